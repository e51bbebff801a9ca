#include "properties/explore/regressions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "reference/text/input_error.hpp"
#include "reference/text/line_source.hpp"
#include "reference/text/nearest_name.hpp"
#include "reference/text/plain_json.hpp"
#include "reference/text/printable.hpp"
#include "verify/vectors/generate.hpp"
#include "verify/vectors/known_answer.hpp"

namespace tps::properties {
namespace {

constexpr std::size_t kLongestRegression = std::size_t{1} << 20U;
constexpr std::size_t kLongestReason = 300;

std::vector<std::string> law_ids() {
  std::vector<std::string> ids;
  for (const Law& law : laws()) ids.push_back(law.text.id);
  return ids;
}

/// The lists of a group go together.
void check_group(const Case& c) {
  const auto size = [&](const char* key) { return c.numbers.at(key).size(); };
  const std::size_t bodies = size("m"), components = bodies * static_cast<std::size_t>(c.dimension);
  if (bodies < 2 || size("u") != components || size("v") != components)
    throw std::invalid_argument(
        "m needs a number for each of two bodies or more, u and v a vector for each in a row");
  if (size("i") != size("j") || size("i") != size("c"))
    throw std::invalid_argument("i, j and c need a number for each collision");
  for (const char* key : {"i", "j"}) {
    for (const double n : c.numbers.at(key)) {
      if (n >= static_cast<double>(bodies))
        throw std::invalid_argument(fmt::format("{} names body {} of {}", key, n, bodies));
    }
  }
}

/// The case has the keys that the law's own cases have, and as many numbers under each.
void check_numbers(const Law& law, const Case& c) {
  const Case example = generated_case(law, {}, 0, 0);
  for (const auto& [key, values] : example.numbers) {
    if (!c.numbers.contains(key))
      throw std::invalid_argument(fmt::format("a case of {} needs {}", law.text.id, key));
    const bool is_single = !example.numbers.contains("m") && !is_vector(key);
    if (is_single && c.numbers.at(key).size() != 1)
      throw std::invalid_argument(
          fmt::format("{} has {} numbers; it has one", key, c.numbers.at(key).size()));
  }
  if (example.numbers.contains("m")) check_group(c);
}

Regression read_regression(const std::string& line, const std::string& name, std::size_t number) {
  const Json json = parse_plain_json(line, name, {}, number);
  const std::string id = json.at("law").get<std::string>();
  const Law* law = find_law(id);
  if (law == nullptr) {
    throw std::invalid_argument(
        fmt::format("there is no law {}{} tps properties --list has all", id, did_you_mean(id, law_ids())));
  }
  const Case c = read_case(json.at("case"));
  check_numbers(*law, c);
  return {law, c, json.at("subject").get<std::string>(), json.at("why").get<std::string>()};
}

/// One line, without its id; empty where the question has no known answer.
Json answered(const Question& question) {
  try {
    return vectors::known_answer(question.op, question.in);
  } catch (const std::invalid_argument&) {
    return {};
  } catch (const InputError&) {
    return {};
  }
}

}  // namespace

std::string regression_line(const Finding& finding, const std::string& subject) {
  const Json line{{"law", finding.law->text.id},
                  {"case", case_json(finding.shrunk)},
                  {"subject", subject},
                  {"why", finding.outcome.why}};
  return json_text(line) + "\n";
}

std::vector<Regression> read_regressions(std::istream& in, const std::string& name) {
  std::vector<Regression> regressions;
  std::string line;
  LineRead read;
  for (std::size_t number = 1; read_line(in, line, kLongestRegression, read); ++number) {
    try {
      if (read.too_long)
        throw std::invalid_argument(fmt::format("is longer than {} bytes; no case is", kLongestRegression));
      regressions.push_back(read_regression(line, name, number));
    } catch (const nlohmann::json::exception& error) {
      throw InputError(
          {{name, number, "", fmt::format("is no regression: {}", printable(error.what(), kLongestReason))}});
    } catch (const std::invalid_argument& error) {
      throw InputError({{name, number, "", error.what()}});
    }
  }
  return regressions;
}

bool fits(const Case& c, const Format& format) {
  return std::all_of(c.numbers.begin(), c.numbers.end(), [&](const auto& entry) {
    return std::all_of(entry.second.begin(), entry.second.end(), [&](double x) {
      const bool in_range = x == 0 || std::isinf(x) || std::abs(std::ilogb(x)) < format.max_exponent;
      return in_range && format.rounded(x) == x;
    });
  });
}

std::string known_answer_file(const std::vector<const Finding*>& findings, std::uint64_t seed) {
  std::map<Op, std::vector<Json>> cases;
  for (const Finding* finding : findings) {
    std::vector<std::string> seen;
    for (const Question& question : finding->questions) {
      const std::string in = json_text(question.in);
      if (std::find(seen.begin(), seen.end(), in) != seen.end()) continue;
      seen.push_back(in);
      const Json answer = question.op == Op::distance ? Json() : answered(question);
      if (answer.empty()) continue;
      std::vector<Json>& section = cases[question.op];
      Json line{{"id", fmt::format("{}.broken_laws.{:05}", operations::name(question.op), section.size())},
                {"rev", 1},
                {"in", question.in}};
      line.update(answer);
      line["tags"] = {finding->shrunk.hazard, finding->law->text.id};
      line["level"] = 3;
      line["accept"] = vectors::accepted_by(question.op);
      section.push_back(line);
    }
  }
  std::string text;
  for (const auto& [op, section] : cases) {
    const vectors::Stratum stratum{op, "broken_laws", "cases in which an implementation broke a law",
                                   static_cast<int>(section.size()), nullptr};
    Json header = Json::parse(vectors::header_line(stratum, seed, {0, section.size()}));
    header["generator"] = "tps properties";
    text += json_text(header) + "\n";
    for (const Json& line : section) text += json_text(line) + "\n";
  }
  return text;
}

}  // namespace tps::properties
