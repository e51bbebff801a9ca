#include "verify/vectors/check_answers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <map>
#include <new>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <vector>

#include "reference/text/hexfloat.hpp"
#include "reference/text/input_error.hpp"
#include "reference/text/number_text.hpp"
#include "reference/text/plain_json.hpp"
#include "reference/text/printable.hpp"
#include "verify/operations/no_answer.hpp"

namespace tps::vectors {
namespace {

/// Where the truth is.
struct Target {
  double lo, hi, nearest;
};

Target target(const Json& ends, const Json& nearest) {
  const double lo = read_number(ends.at(0));
  const double hi = read_number(ends.at(1));
  return {lo, hi, nearest == "lo" ? lo : nearest == "hi" ? hi : std::nextafter(lo, HUGE_VAL)};
}

/// A tolerance class such as R, U(2), K(8).
struct Accepted {
  char letter;
  double factor;
};

Accepted accepted_class(const std::string& text) {
  if (text == "R") return {'R', 0};
  double factor = 0;
  const bool has_factor =
      text.size() > 3 && text[1] == '(' && text.back() == ')' &&
      std::from_chars(text.data() + 2, text.data() + text.size() - 1, factor).ec == std::errc();
  constexpr double kWidest = 0x1p40;  // beyond that a class accepts nearly anything
  if (!has_factor || (text[0] != 'U' && text[0] != 'K') || !(factor >= 0 && factor <= kWidest)) {
    throw std::invalid_argument(
        fmt::format("accept has {}; known classes: R, U(k), K(k), k up to 2^40", text.substr(0, 60)));
  }
  return {text[0], factor};
}

double outside(double x, const Target& t) {
  return x < t.lo ? t.lo - x : x > t.hi ? x - t.hi : 0;
}

bool passes(const Accepted& accepted, const std::vector<double>& found, const std::vector<Target>& known,
            const Json& cond) {
  double size = 0, miss = 0;
  bool rounded = true, in_units = true;
  for (std::size_t k = 0; k < known.size(); ++k) {
    rounded = rounded && found[k] == known[k].nearest;
    const double excess = outside(found[k], known[k]);
    const double unit = std::nextafter(std::fabs(known[k].nearest), HUGE_VAL) - std::fabs(known[k].nearest);
    in_units = in_units && excess <= accepted.factor * unit;
    size = std::hypot(size, known[k].nearest);
    miss = std::hypot(miss, excess);
  }
  if (accepted.letter == 'R') return rounded;
  if (accepted.letter == 'U') return in_units;
  return miss == 0 || (cond.is_number() && miss <= accepted.factor * 0x1p-53 * cond.get<double>() * size);
}

/// All numbers of a result, however nested.
void flatten(const Json& value, std::vector<double>& numbers) {
  if (!value.is_array()) return numbers.push_back(read_number(value));
  for (const Json& element : value) flatten(element, numbers);
}

std::optional<std::string> wrong_numbers(const std::string& key, const Json& given,
                                         const std::vector<Target>& known, const Json& cond,
                                         const Json& accept) {
  std::vector<double> found;
  flatten(given, found);
  if (found.size() != known.size())
    return fmt::format("{} has {} numbers; it has {}", key, found.size(), known.size());
  for (const Json& text : accept) {
    if (passes(accepted_class(text.get<std::string>()), found, known, cond)) return std::nullopt;
  }
  for (std::size_t k = 0; k < known.size(); ++k) {
    if (found[k] == known[k].nearest) continue;
    return fmt::format("{} is {}, the nearest double is {}; accepted: {}", key,
                       hex(found[k]).get<std::string>(), hex(known[k].nearest).get<std::string>(),
                       json_text(accept));
  }
  return std::nullopt;
}

std::optional<std::string> wrong_word(const char* key, const Json& known, const Json& out) {
  if (!out.contains(key)) return fmt::format("{} is missing; it is {}", key, json_text(known));
  if (out.at(key) == known) return std::nullopt;
  return fmt::format("{} is {}; it is {}", key, json_text(out.at(key)), json_text(known));
}

std::optional<std::string> wrong_time(const Json& known_case, const Json& out) {
  if (!out.contains("verdict") && !out.contains("t")) return kSaysNothing;
  if (out.contains("verdict")) {
    if (const auto wrong = wrong_word("verdict", known_case.at("verdict"), out)) return wrong;
  }
  const Json& known = known_case.at("t");
  const Json given = out.value("t", Json());
  if (known.is_null() || given.is_null()) {
    if (known.is_null() && given.is_null()) return std::nullopt;
    return known.is_null() ? fmt::format("t is {}; there is no event", json_text(given))
                           : fmt::format("t is absent; the event is at {}", json_text(known.at(0)));
  }
  return wrong_numbers("t", given, {target(known, known_case.at("nearest"))}, known_case.at("cond"),
                       known_case.at("accept"));
}

/// By one of the accepted answers: the case's own, or one of "also".
std::optional<std::string> wrong_response(const Json& answer, const Json& known_case, const Json& out) {
  if (answer.contains("kind")) {
    if (const auto wrong = wrong_word("kind", answer.at("kind"), out)) return wrong;
  }
  for (const auto& [key, enclosures] : answer.at("out").items()) {
    if (!out.contains(key)) return fmt::format("{} is missing", key);
    std::vector<Target> known;
    for (std::size_t k = 0; k < enclosures.size(); ++k) {
      known.push_back(target(enclosures[k], answer.at("nearest").at(key).at(k)));
    }
    const Json cond = known_case.at("cond").value(key, Json());
    if (const auto wrong = wrong_numbers(key, out.at(key), known, cond, known_case.at("accept")))
      return wrong;
  }
  return std::nullopt;
}

std::optional<std::string> wrong_event(const Json& known_case, const Json& out) {
  for (const char* key : {"i", "j"}) {
    if (const auto wrong = wrong_word(key, known_case.at(key), out)) return wrong;
  }
  if (auto wrong = wrong_state(out, known_case.at("in").at("scene").at("particles").size())) return wrong;
  return wrong_response(known_case, known_case, in_rows(out));
}

std::string in_words(const InputError& error) {
  std::string text;
  for (const InputProblem& problem : error.problems()) {
    if (!text.empty()) text += "; ";
    text += problem.pointer.empty() ? problem.message : problem.pointer + ": " + problem.message;
  }
  return text;
}

/// The classes of a case: one at least, each a known one.
std::optional<std::string> wrong_classes(const Json& accept) {
  if (!accept.is_array() || accept.empty()) return "accept is not a list of classes: R, U(k), K(k)";
  try {
    for (const Json& text : accept) {
      if (!text.is_string()) return fmt::format("accept has {}, which is no class", json_text(text));
      static_cast<void>(accepted_class(text.get<std::string>()));
    }
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return std::nullopt;
}

bool is_word(const Json& json) {
  return json.is_string();
}

/// What is no part of a case, or not as it should be: an answer that is stored beside the proven one is
/// believed by nobody, and a key that is misspelt says nothing.
std::optional<std::string> wrong_in_form(const Json& known_case, const Json& proven) {
  struct Part {
    const char* allowed;
    bool (*is_right)(const Json&);
  };
  static const std::map<std::string, Part> parts{
      {"rev",
       {"a whole number from 1",
        [](const Json& x) { return x.is_number_integer() && x >= 1 && x <= 1'000'000; }}},
      {"level", {"1, 2 or 3", [](const Json& x) { return x.is_number_integer() && x >= 1 && x <= 3; }}},
      {"tags",
       {"a list of words",
        [](const Json& x) { return x.is_array() && std::all_of(x.begin(), x.end(), is_word); }}},
      {"twin", {"a word", is_word}},
      {"why", {"a word", is_word}}};
  for (const auto& [key, value] : known_case.items()) {
    if (proven.contains(key) || key == "id" || key == "in" || key == "accept") continue;
    const auto part = parts.find(key);
    if (part == parts.end())
      return fmt::format("{} is no key of this case: nothing of the kind is proven", printable(key, 100));
    if (!part->second.is_right(value))
      return fmt::format("{} is {}; allowed: {}", key, shown(value), part->second.allowed);
  }
  return std::nullopt;
}

/// The same with every hexadecimal float in it spelt in one way.
Json in_one_spelling(Json value) {
  if (value.is_structured()) {
    for (Json& part : value) part = in_one_spelling(std::move(part));
  } else if (value.is_string()) {
    const HexFloat number = parse_hex_float(value.get_ref<const std::string&>());
    if (number.verdict == HexFloat::Verdict::exact) return to_hex<double>(number.value);
  }
  return value;
}

/// Why the question has no proven answer, in words.
template <typename Ask>
std::optional<std::string> unanswerable(const Ask& ask) {
  try {
    ask();
    return std::nullopt;
  } catch (const InputError& error) {
    return "no question of the operation: " + in_words(error);
  } catch (const operations::NoAnswer& why) {
    return "no question of the operation: " + in_words(why.in("", 0, "/in"));
  } catch (const std::bad_alloc&) {
    return "not enough memory for this case";
  } catch (const std::exception& error) {
    return error.what();
  }
}

}  // namespace

std::optional<std::string> wrong_state(const Json& out, std::size_t particles) {
  const auto state = out.find("state");
  if (state == out.end()) return std::nullopt;
  if (!state->is_array()) return "state is " + shown(*state) + "; it is a list of particles";
  std::set<std::int64_t> ids;
  for (const Json& particle : *state) {
    const bool is_one = particle.is_object() && particle.contains("id") &&
                        particle.at("id").is_number_integer() && particle.contains("position") &&
                        particle.contains("velocity");
    if (!is_one) {
      return "state has " + shown(particle) +
             R"(, which is no particle; one is {"id":0,"position":[…],"velocity":[…]})";
    }
    const auto id = particle.at("id").get<std::int64_t>();
    if (!ids.insert(id).second) return fmt::format("state has particle {} twice", id);
  }
  if (ids.size() == particles) return std::nullopt;
  return fmt::format("state has {} particles; the scene has {}", ids.size(), particles);
}

Json in_rows(Json out) {
  Json state = out.value("state", Json::array());
  std::sort(state.begin(), state.end(), [](const Json& one, const Json& other) {
    return one.at("id").get<std::int64_t>() < other.at("id").get<std::int64_t>();
  });
  for (const Json& particle : state) {
    out["positions"].push_back(particle.at("position"));
    out["velocities"].push_back(particle.at("velocity"));
  }
  return out;
}

std::optional<std::string> wrong_in_case(Op op, const Json& known_case) {
  if (!known_case.is_object() || !known_case.contains("in"))
    return "has no \"in\"; a case is a question and its answer";
  if (!known_case.contains("id") || !known_case.at("id").is_string()) return "has no id that is a word";
  Json proven;
  if (const auto why = unanswerable([&] { proven = known_answer(op, known_case.at("in")); })) return why;
  for (const auto& [key, value] : proven.items()) {
    const Json stored = known_case.value(key, Json());
    if (stored != value && in_one_spelling(stored) != value)
      return fmt::format("{} is {}; proven: {}", key, json_text(stored), json_text(value));
  }
  if (auto wrong = wrong_in_form(known_case, proven)) return wrong;
  return wrong_classes(known_case.value("accept", Json()));
}

std::optional<std::string> wrong_in_answer(Op op, const Json& known_case, const Json& out) {
  if (!out.is_object()) return "out is not an object";
  try {
    if (op == Op::order) return wrong_word("order", known_case.at("order"), out);
    if (op == Op::next_event) return wrong_event(known_case, out);
    if (known_case.contains("verdict")) return wrong_time(known_case, out);
    const auto wrong = wrong_response(known_case, known_case, out);
    for (const Json& other : known_case.value("also", Json::array())) {
      if (wrong && !wrong_response(other, known_case, out)) return std::nullopt;
    }
    return wrong;
  } catch (const std::exception& error) {
    return error.what();
  }
}

}  // namespace tps::vectors
