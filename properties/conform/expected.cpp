#include "properties/conform/expected.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "reference/text/number_text.hpp"
#include "reference/text/plain_json.hpp"
#include "verify/vectors/check_answers.hpp"

namespace tps::properties::conform {
namespace {

ExpectedNumbers::End end_of(const Json& ends, const Json& nearest) {
  const double lo = vectors::read_number(ends.at(0)), hi = vectors::read_number(ends.at(1));
  return {lo, hi, nearest == "lo" ? lo : nearest == "hi" ? hi : std::nextafter(lo, HUGE_VAL)};
}

std::optional<double> condition_of(const Json& cond) {
  return cond.is_number() ? std::optional(cond.get<double>()) : std::nullopt;
}

Expected timing(const Json& answer) {
  Expected expected{{{"verdict", answer.at("verdict")}}, {}, true, !answer.at("t").is_null()};
  if (expected.occurs)
    expected.numbers.push_back(
        {"t", {end_of(answer.at("t"), answer.at("nearest"))}, condition_of(answer.at("cond"))});
  return expected;
}

Expected response(const Json& answer, const Json& cond) {
  Expected expected;
  for (const char* key : {"kind", "i", "j"}) {
    if (answer.contains(key)) expected.words.push_back({key, answer.at(key)});
  }
  for (const auto& [key, enclosures] : answer.at("out").items()) {
    ExpectedNumbers numbers{key, {}, condition_of(cond.value(key, Json()))};
    for (std::size_t n = 0; n < enclosures.size(); ++n)
      numbers.ends.push_back(end_of(enclosures[n], answer.at("nearest").at(key).at(n)));
    expected.numbers.push_back(std::move(numbers));
  }
  return expected;
}

void flatten(const Json& value, std::vector<double>& numbers, bool& all) {
  if (value.is_array()) {
    for (const Json& each : value) flatten(each, numbers, all);
    return;
  }
  double x = NAN;
  if (value.is_number()) x = value.get<double>();
  if (value.is_string()) {
    const std::string& text = value.get_ref<const std::string&>();
    if (text == "inf" || text == "-inf" || parse_hex_float(text).verdict != HexFloat::Verdict::malformed)
      x = std::strtod(text.c_str(), nullptr);
  }
  all = all && !std::isnan(x);
  numbers.push_back(x);
}

/// In so many digits that another number is spelt otherwise.
std::string spelt(double x) {
  return fmt::format("{}", x);
}

bool is_nearest(double x, const ExpectedNumbers::End& end, const Format& format) {
  if (format.bits == 53) return x == end.nearest;
  if (format.bits > 53) return end.lo <= x && x <= end.hi;
  return x == format.rounded(end.lo) || x == format.rounded(end.hi);
}

/// Adds what a result says.
void compare_numbers(const ExpectedNumbers& expected, const Json& given, const Format& format, double k,
                     Comparison& comparison) {
  const auto found = numbers_of(given);
  if (!found || found->size() != expected.ends.size()) {
    comparison.numbers = comparison.within = comparison.nearest = false;
    if (comparison.problem.empty()) {
      comparison.problem = found ? fmt::format("{} has {} numbers; it has {}", expected.key, found->size(),
                                               expected.ends.size())
                                 : fmt::format(
                                       "{} is {}, which is not a number; a number is one of JSON, or a "
                                       "hexadecimal float in a string",
                                       expected.key, tps::shown(given));
    }
    return;
  }
  double miss = 0, size = 0;
  std::optional<std::size_t> first;
  for (std::size_t n = 0; n < found->size(); ++n) {
    const ExpectedNumbers::End& end = expected.ends[n];
    const double x = (*found)[n];
    size = std::hypot(size, end.nearest);
    miss = std::hypot(miss, x < end.lo ? end.lo - x : x > end.hi ? x - end.hi : 0);
    if (!is_nearest(x, end, format) && !first) first = n;
  }
  comparison.nearest = comparison.nearest && !first;
  const double unit = std::ldexp(size, -std::min(format.bits, 53));
  const double units = miss == 0 ? 0 : miss / unit;
  // The format's own rounding of a result is half a unit of it; doubles have their enclosures for that.
  const double allowed = (format.bits < 53 ? 0.5 : 0) + (expected.cond ? k * *expected.cond : 0);
  if (size > 0 && units > comparison.units) {  // of 0 there are no units
    comparison.units = units;
    comparison.cond = expected.cond.value_or(0);
  }
  const bool within = miss == 0 || units <= allowed;
  comparison.within = comparison.within && within;
  if (!first || (!comparison.problem.empty() && (within || !comparison.is_minor))) return;
  comparison.is_minor = within;
  comparison.problem = fmt::format("{} is {}; right is {}", expected.key, spelt((*found)[*first]),
                                   spelt(expected.ends[*first].nearest));
  if (size > 0 && miss > 0) comparison.problem += fmt::format(", {:.3g} units of its size away", units);
}

void compare_time(const Expected& expected, const Json& out, const Format& format, double k,
                  Comparison& comparison) {
  const Json t = out.value("t", Json());
  if (expected.occurs != !t.is_null()) {
    comparison.words = comparison.within = comparison.nearest = comparison.occurs = false;
    if (!comparison.problem.empty()) return;
    comparison.is_minor = false;
    const auto given = numbers_of(t);
    comparison.problem =
        expected.occurs ? fmt::format("no event; right is {} at t = {}", tps::shown(expected.words[0].word),
                                      spelt(expected.numbers[0].ends[0].nearest))
                        : fmt::format("an event at t = {}; right is none, {}",
                                      given && given->size() == 1 ? spelt(given->front()) : tps::shown(t),
                                      tps::shown(expected.words[0].word));
  }
  for (const ExpectedNumbers& numbers : expected.numbers) {
    if (!t.is_null()) compare_numbers(numbers, t, format, k, comparison);
  }
}

}  // namespace

std::vector<Expected> expected_of(const KnownQuestion& known) {
  const Json& answer = known.answer;
  if (answer.contains("order")) return {{{{"order", answer.at("order")}}, {}}};
  if (answer.contains("verdict")) return {timing(answer)};
  std::vector<Expected> all{response(answer, answer.at("cond"))};
  for (const Json& other : answer.value("also", Json::array()))
    all.push_back(response(other, answer.at("cond")));
  return all;
}

std::optional<std::vector<double>> numbers_of(const Json& value) {
  std::vector<double> numbers;
  bool all = true;
  flatten(value, numbers, all);
  return all ? std::optional(std::move(numbers)) : std::nullopt;
}

double accepted_factor(const Json& accept) {
  double factor = 0;
  for (const Json& text : accept) {
    const std::string& name = text.get_ref<const std::string&>();
    if (name.starts_with("K(")) factor = std::max(factor, std::strtod(name.c_str() + 2, nullptr));
  }
  return factor;
}

Comparison compare(const Expected& expected, const Question& question, Json out, const Format& format,
                   double k) {
  Comparison comparison;
  if (question.op == Op::next_event) {
    if (auto wrong = vectors::wrong_state(out, question.in.at("scene").at("particles").size())) {
      comparison.words = comparison.numbers = comparison.within = comparison.nearest = false;
      comparison.is_minor = false;
      comparison.problem = std::move(*wrong);
      return comparison;
    }
    out = vectors::in_rows(std::move(out));
  }
  for (const ExpectedWord& each : expected.words) {
    if (expected.is_timing && !out.contains(each.key) && out.contains("t"))
      continue;  // a time alone is judged, too
    const Json found = out.value(each.key, Json());
    if (found == each.word) continue;
    comparison.words = comparison.is_minor = false;
    if (comparison.problem.empty()) {
      comparison.problem =
          fmt::format("{} is {}; right is {}", each.key, tps::shown(found), tps::shown(each.word));
    }
  }
  if (expected.is_timing) {
    compare_time(expected, out, format, k, comparison);
    return comparison;
  }
  for (const ExpectedNumbers& numbers : expected.numbers)
    compare_numbers(numbers, out.value(numbers.key, Json()), format, k, comparison);
  return comparison;
}

}  // namespace tps::properties::conform
