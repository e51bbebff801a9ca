#include "properties/conform/verdict.hpp"

#include <fnmatch.h>

#include <algorithm>
#include <numeric>

namespace tps::properties::conform {

std::uint64_t Row::asked() const {
  return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
}

const Example* Row::worst_example() const {
  for (std::size_t c = kClasses; c-- > 0;) {
    if (examples[c]) return &*examples[c];
  }
  return nullptr;
}

void Row::add(const Grade& grade, const std::function<Example()>& show) {
  ++counts[index_of(grade.which)];
  // Of answers that hold to rounding the worst is told, of others the first.
  if (grade.which == Class::right) return;
  if (grade.which == Class::rounding) {
    if (grade.cond == 0) return;  // terms cancel: there are no units of its size
    // By what the condition of the question does not explain.
    if (grade.units * std::max(worst_cond, 1.0) > worst_units * std::max(grade.cond, 1.0)) {
      worst_units = grade.units;
      worst_cond = grade.cond;
    }
    return;
  }
  std::optional<Example>& example = examples[index_of(grade.which)];
  if (example) return;
  example = show();
  example->which = grade.which;
  example->units = grade.units;
  example->cond = grade.cond;
  if (example->why.empty()) example->why = grade.why;
}

bool Profile::accepts(const Row& row) const {
  for (std::size_t c = 0; c < kClasses; ++c) {
    if (fails[c] && row.counts[c] > 0) return false;
  }
  return true;
}

void Verdict::note_failure(Failure failure) {
  constexpr std::size_t kShown = 5;
  ++failed;
  if (failures.size() < kShown) failures.push_back(std::move(failure));
}

std::array<std::uint64_t, kClasses> Verdict::counts() const {
  std::array<std::uint64_t, kClasses> sums{};
  for (const Row& row : rows) {
    for (std::size_t c = 0; c < kClasses; ++c) sums[c] += row.counts[c];
  }
  return sums;
}

std::uint64_t Verdict::asked() const {
  const auto sums = counts();
  return std::accumulate(sums.begin(), sums.end(), std::uint64_t{0});
}

namespace {

bool names(const std::string& pattern, const Row& row) {
  return ::fnmatch(pattern.c_str(), row.name.c_str(), 0) == 0;
}

}  // namespace

bool Verdict::expected_to_fail(const Row& row) const {
  return std::any_of(expected_failures.begin(), expected_failures.end(),
                     [&](const std::string& pattern) { return names(pattern, row); });
}

std::vector<const Row*> Verdict::failing() const {
  std::vector<const Row*> found;
  for (const Row& row : rows) {
    if (!profile.accepts(row) && !expected_to_fail(row)) found.push_back(&row);
  }
  return found;
}

bool Verdict::has_row(const std::string& pattern) const {
  return std::any_of(rows.begin(), rows.end(), [&](const Row& row) { return names(pattern, row); });
}

std::vector<std::string> Verdict::unexpected_passes() const {
  std::vector<std::string> found;
  for (const std::string& pattern : expected_failures) {
    const bool fails = std::any_of(rows.begin(), rows.end(), [&](const Row& row) {
      return names(pattern, row) && !profile.accepts(row);
    });
    if (!fails) found.push_back(pattern);
  }
  return found;
}

std::vector<std::string> Verdict::best_hypotheses(const Row& row) {
  std::uint64_t most = 0;
  for (const auto& [name, count] : row.hypotheses) most = std::max(most, count);
  std::vector<std::string> best;
  for (const auto& [name, count] : row.hypotheses) {
    if (count == most && 2 * most >= row.of_class(Class::wrong)) best.push_back(name);
  }
  return best;
}

}  // namespace tps::properties::conform
