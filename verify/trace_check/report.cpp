#include "verify/trace_check/report.hpp"

#include <algorithm>

#include "verify/trace_check/tally.hpp"

namespace tps::check {
namespace {

std::uint64_t total(const std::array<RuleResult, kRules>& rules, std::uint64_t RuleResult::*count) {
  std::uint64_t sum = 0;
  for (const RuleResult& rule : rules) sum += rule.*count;
  return sum;
}

}  // namespace

std::uint64_t CheckReport::violated() const {
  return total(rules, &RuleResult::violated);
}
std::uint64_t CheckReport::undecided() const {
  return total(rules, &RuleResult::undecided);
}
bool CheckReport::inconclusive() const {
  return conforming() && undecided() > std::max<std::uint64_t>(2, events / 100);
}

/// A mean that is six standard errors and a twentieth of an ulp away from zero, of 10^4 residuals at least, is a
/// bias: chance has it once in 10^9 sums.
void Tally::close_sums() {
  constexpr std::uint64_t kEnough = 10'000;
  constexpr double kErrors = 6;
  constexpr double kSmallest = 0.05;
  bool judged = false;
  for (const auto& [quantity, m] : moments_) {
    const double n = static_cast<double>(m.count);
    const double mean = m.sum / n;
    const double variance = std::max(0.0, m.squares / n - mean * mean);
    const double error = m.count > 1 ? std::sqrt(variance / (n - 1)) : 0;
    report_.sums.push_back({quantity, m.count, mean, error});
    if (m.count < kEnough) continue;
    judged = true;
    step = {report_.lines, report_.events, {}, {}};
    demand(Rule::bias, std::fabs(mean) <= std::max(kErrors * error, kSmallest) * tolerance_, [&](Finding& f) {
      f.message = "residuals of the " + quantity + " have a mean of " + std::to_string(mean) +
                  " ulps with a standard error of " + std::to_string(error);
    });
  }
  if (!judged) not_judged(Rule::bias, "fewer than 10000 residuals");
}

}  // namespace tps::check
