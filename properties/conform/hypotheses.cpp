#include "properties/conform/hypotheses.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <exception>

#include "properties/conform/mistakes.hpp"

namespace tps::properties::conform {
namespace {

const std::vector<Mistake>& mistakes() {
  static const std::vector<Mistake> all = [] {
    std::vector<Mistake> made;
    add_timing_mistakes(made);
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

double apart(const Vec& a, const Vec& b) {
  if (a.size() != b.size()) return HUGE_VAL;
  const double distance = norm(a - b);
  return distance == 0 ? 0 : distance / std::max(norm(a), norm(b));
}

bool fits(const Mistake& mistake, const KnownQuestion& known, const Json& out, const Expected& right) {
  try {
    const auto mistaken = mistake.answer(Given(known.question.in));
    if (!mistaken) return false;
    const Json word = out.value(known.question.op == "order" ? "order" : "kind", Json());
    if (!mistaken->word.empty() && word != mistaken->word) return false;
    bool tells = !mistaken->word.empty() && (right.words.empty() || right.words[0].word != mistaken->word);
    for (const auto& [key, numbers] : mistaken->numbers) {
      const auto found = found_numbers(out, key);
      if (!found || !(apart(*found, numbers) <= 1e-9)) return false;
      tells = tells || apart(numbers, right_numbers(right, key)) > 1e-7;
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

/// Errors of the size of single precision: 2^-30 to 2^-18 of a result and of its condition.
bool single_precision(const std::vector<std::pair<double, double>>& pairs, const Expected& right) {
  Vec found, exact;
  for (const auto& [x, y] : pairs) {
    found.push_back(x);
    exact.push_back(y);
  }
  double cond = 1;
  for (const ExpectedNumbers& numbers : right.numbers) cond = std::max(cond, numbers.cond.value_or(1));
  const double relative = apart(found, exact);
  return relative > 0x1p-30 && relative < 0x1p-18 * cond;
}

const std::string kSinglePrecision = "float32 inside";

}  // namespace

std::vector<std::string> hypotheses_fitting(const KnownQuestion& known, const Json& out) {
  std::vector<std::string> fitting;
  if (!out.is_object()) return fitting;
  const Expected right = expected_of(known).front();
  for (const Mistake& mistake : mistakes()) {
    const bool is_of =
        std::find(mistake.ops.begin(), mistake.ops.end(), known.question.op) != mistake.ops.end();
    if (is_of && fits(mistake, known, out, right)) fitting.push_back(mistake.name);
  }
  const auto pairs = side_by_side(out, right);
  if (pairs.empty()) return fitting;
  if (const auto digits = written_short(pairs)) {
    fitting.push_back(*digits);
  } else if (single_precision(pairs, right)) {
    fitting.push_back(kSinglePrecision);
  }
  return fitting;
}

std::vector<std::string> hypothesis_names() {
  std::vector<std::string> names;
  for (const Mistake& mistake : mistakes()) {
    if (std::find(names.begin(), names.end(), mistake.name) == names.end()) names.push_back(mistake.name);
  }
  names.insert(names.end(), {"written with n digits", "written with n decimals", kSinglePrecision});
  return names;
}

}  // namespace tps::properties::conform
