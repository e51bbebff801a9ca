#include "properties/explore/explore.hpp"

#include <fnmatch.h>

#include <algorithm>
#include <numeric>

#include "reference/process/interrupt.hpp"

namespace tps::properties {
namespace {

constexpr std::uint64_t kCasesOfARound = 50;

/// @return whether it was examined to the end of the extent, or found wanting.
bool examined(LawReport& report, Implementation& subject, const Extent& extent,
              const std::function<bool()>& stop) {
  try {
    std::optional<Finding> found = check_law(*report.law, subject, extent, report.tally, stop);
    const bool refused_again = report.finding && found && found->outcome.kind == Outcome::Kind::refused;
    if (found && !refused_again) report.finding = std::move(found);
    return true;
  } catch (const interrupt::Interrupted&) {
    return false;
  }
}

}  // namespace

std::uint64_t Exploration::held() const {
  return std::accumulate(laws.begin(), laws.end(), std::uint64_t{0},
                         [](std::uint64_t sum, const LawReport& each) { return sum + each.tally.held; });
}

std::vector<const Finding*> Exploration::findings() const {
  std::vector<const Finding*> found;
  for (const LawReport& each : laws) {
    if (each.finding) found.push_back(&*each.finding);
  }
  return found;
}

Exploration explore(Implementation& subject, const Plan& plan, const std::function<bool()>& stop,
                    const std::function<void(const Exploration&)>& after_round) {
  Exploration exploration{subject.name(), plan, plan.first, {}};
  for (const Law* law : plan.laws) exploration.laws.push_back({law, {}, std::nullopt});
  const std::uint64_t end = plan.first + plan.count;
  while (exploration.next < end && !stop() &&
         !std::all_of(exploration.laws.begin(), exploration.laws.end(), std::mem_fn(&LawReport::is_done))) {
    const std::uint64_t count = std::min(kCasesOfARound, end - exploration.next);
    for (LawReport& report : exploration.laws) {
      if (report.is_done()) continue;
      if (!examined(report, subject, {plan.seed, exploration.next, count, plan.bitwise}, stop))
        return exploration;
    }
    if (stop() || !subject.given_up().empty()) break;  // the round is asked again when going on
    exploration.next += count;
    after_round(exploration);
  }
  return exploration;
}

std::vector<const Law*> laws_matching(const std::vector<std::string>& patterns) {
  std::vector<const Law*> chosen;
  for (const Law& law : laws()) {
    const bool wanted =
        patterns.empty() || std::any_of(patterns.begin(), patterns.end(), [&](const auto& pattern) {
          return ::fnmatch(pattern.c_str(), law.text.id.c_str(), 0) == 0 || law.text.number == pattern;
        });
    if (wanted) chosen.push_back(&law);
  }
  return chosen;
}

}  // namespace tps::properties
