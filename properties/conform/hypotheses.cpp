#include "properties/conform/hypotheses.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <exception>

#include "properties/conform/finite_for_infinite.hpp"
#include "properties/conform/mistakes.hpp"
#include "properties/conform/single_precision.hpp"

namespace tps::properties::conform {
namespace {

const std::vector<Mistake>& mistakes() {
  static const std::vector<Mistake> all = [] {
    std::vector<Mistake> made;
    add_timing_mistakes(made);
    add_threshold_mistakes(made);
    add_response_mistakes(made);
    add_group_mistakes(made);
    add_effect_mistakes(made);
    return made;
  }();
  return all;
}

/// The right numbers of a result, empty where a timing query has no event.
Vec right_numbers(const Expected& expected, const std::string& key) {
  for (const ExpectedNumbers& numbers : expected.numbers) {
    if (numbers.key != key) continue;
    Vec nearest;
    for (const ExpectedNumbers::End& end : numbers.ends) nearest.push_back(end.nearest);
    return nearest;
  }
  return {};
}

std::optional<Vec> found_numbers(const Json& out, const std::string& key) {
  const Json value = out.value(key, Json());
  return value.is_null() ? std::optional(Vec{}) : numbers_of(value);
}

/// Whether the verdict that an answer gives is one of the mistake's: who moves is not static by chance.
bool may_be_called_so(const Mistaken& mistaken, const Expected& right, const Json& out) {
  const auto verdict = out.find("verdict");
  if (!right.is_timing || verdict == out.end()) return true;
  const auto& names = mistaken.verdicts;
  if (names.empty()) return *verdict != "static" || right.words[0].word == "static";
  return std::any_of(names.begin(), names.end(), [&](const std::string& name) { return *verdict == name; });
}

bool fits(const Mistake& mistake, const KnownQuestion& known, const Json& out, const Expected& right) {
  try {
    const auto mistaken = mistake.answer(Given(known.question.in));
    if (!mistaken) return false;
    const Json word = out.value(known.question.op == Op::order ? "order" : "kind", Json());
    if (!mistaken->word.empty() && word != mistaken->word) return false;
    if (!may_be_called_so(*mistaken, right, out)) return false;
    bool tells = !mistaken->word.empty() && (right.words.empty() || right.words[0].word != mistaken->word);
    for (const auto& [key, numbers] : mistaken->numbers) {
      const auto found = found_numbers(out, key);
      if (!found || !(apart(*found, numbers) <= mistaken->equal)) return false;
      tells = tells || apart(numbers, right_numbers(right, key)) > mistaken->apart;
    }
    return tells;
  } catch (const std::exception&) {
    return false;  // a question of other keys
  }
}

/// Every number of an answer beside the right one; empty where they do not correspond.
std::vector<std::pair<double, double>> side_by_side(const Json& out, const Expected& right) {
  std::vector<std::pair<double, double>> pairs;
  for (const ExpectedNumbers& numbers : right.numbers) {
    const auto found = found_numbers(out, numbers.key);
    if (!found || found->size() != numbers.ends.size()) return {};
    for (std::size_t n = 0; n < found->size(); ++n) pairs.emplace_back((*found)[n], numbers.ends[n].nearest);
  }
  return pairs;
}

/// "written with 10 digits": in significant digits, or behind the point.
std::optional<std::string> written_short(const std::vector<std::pair<double, double>>& pairs) {
  const auto written = [](double x, int digits, bool fixed) {
    return std::strtod(
        (fixed ? fmt::format("{:.{}f}", x, digits) : fmt::format("{:.{}e}", x, digits - 1)).c_str(), nullptr);
  };
  for (const bool fixed : {false, true}) {
    for (int digits = 16; digits >= 3; --digits) {  // the most that fit: 0.5 has one of six decimals
      bool all = true, tells = false;
      for (const auto& [found, right] : pairs) {
        // The digits of a computed number, which may be a unit in the last place from the right one.
        const bool near = found == written(right, digits, fixed) ||
                          found == written(right * (1 + 0x1p-52), digits, fixed) ||
                          found == written(right * (1 - 0x1p-52), digits, fixed);
        all = all && near && std::isfinite(right);
        tells = tells || found != right;
      }
      if (all && tells)
        return fixed ? fmt::format("written with {} decimals", digits)
                     : fmt::format("written with {} digits", digits);
    }
  }
  return std::nullopt;
}

const std::string kFiniteMass = "an infinite mass taken as a large finite one";
const std::string kSinglePrecision = "float32 inside";

}  // namespace

std::vector<std::string> hypotheses_fitting(const KnownQuestion& known, const Json& out) {
  std::vector<std::string> fitting;
  if (!out.is_object()) return fitting;
  const Expected right = expected_of(known).front();
  for (const Mistake& mistake : mistakes()) {
    const bool is_of =
        std::find(mistake.ops.begin(), mistake.ops.end(), known.question.op) != mistake.ops.end();
    const bool is_named = std::find(fitting.begin(), fitting.end(), mistake.name) != fitting.end();
    if (is_of && !is_named && fits(mistake, known, out, right)) fitting.push_back(mistake.name);
  }
  const auto pairs = side_by_side(out, right);
  if (pairs.empty()) return fitting;
  if (const auto digits = written_short(pairs)) {
    fitting.push_back(*digits);
  } else if (is_of_finite_mass(known, out, right)) {
    fitting.push_back(kFiniteMass);
  } else if (is_single_precision(known, out, right)) {
    fitting.push_back(kSinglePrecision);
  }
  return fitting;
}

std::vector<std::string> hypothesis_names() {
  std::vector<std::string> names;
  for (const Mistake& mistake : mistakes()) {
    if (std::find(names.begin(), names.end(), mistake.name) == names.end()) names.push_back(mistake.name);
  }
  names.insert(names.end(), {"written with n digits", "written with n decimals", kFiniteMass,
                             kSinglePrecision, kRemembered});
  return names;
}

}  // namespace tps::properties::conform
