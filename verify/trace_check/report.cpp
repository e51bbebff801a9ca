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
bool CheckReport::partial() const {
  return std::ranges::any_of(
      rules, [](const RuleResult& r) { return r.rule != Rule::bias && !r.not_judged.empty(); });
}
bool CheckReport::inconclusive() const {
  return conforming() && undecided() > std::max<std::uint64_t>(2, events / 100);
}

/// Five standard errors away from zero and beyond the smallest that counts, of 10^4 residuals and 10^3
/// independent ones at least, it is a bias: chance has that once in two million sums. Correctly rounded times
/// have none; stable and printed formulas have up to 0.13 u of their own.
void Tally::close_sums() {
  constexpr std::uint64_t kEnough = 10'000;
  constexpr double kIndependent = 1000;
  constexpr double kErrors = 5;
  bool judged = false;
  std::string repeating;
  for (std::size_t n = 0; n < residuals_.size(); ++n) {
    const Residuals& residuals = residuals_[n];
    if (residuals.count() == 0) continue;
    const char* const quantity = kQuantities[n];
    // Certified times are rounded once; energies and momenta come from the same formulas under every timing.
    const double kSmallest =
        report_.timing == "certified" && n == static_cast<std::size_t>(Quantity::time) ? 0.05 : 0.25;
    const double mean = residuals.mean();
    const double error = residuals.standard_error();
    const double independent = residuals.independent();
    report_.sums.push_back({quantity, residuals.count(), mean, error, independent});
    if (residuals.count() < kEnough) continue;
    if (independent < kIndependent) {
      repeating += fmt::format("{}the {} repeats itself: of {} residuals only {:.0f} are independent",
                               repeating.empty() ? "" : "; ", quantity, residuals.count(), independent);
      continue;
    }
    judged = true;
    step.begin(report_.lines, report_.events);
    demand(Rule::bias, std::fabs(mean) <= std::max(kErrors * error, kSmallest) * tolerance_, [&](Finding& f) {
      f.message = fmt::format("residuals of the {} have a mean of {} u with a standard error of {}", quantity,
                              mean, error);
    });
  }
  if (!judged && repeating.empty()) not_judged(Rule::bias, "fewer than 10000 residuals");
  if (!repeating.empty()) not_judged(Rule::bias, repeating);
  for (const auto& [rule, where] : vague_) {
    RuleResult& result = of(rule);
    const std::string steps = result.vague == 1 ? "1 step" : fmt::format("{} steps", result.vague);
    result.not_judged += fmt::format("{}{}, {}", result.not_judged.empty() ? "" : "; ", steps, where);
  }
}

void Tally::take_over(const Tally& later) {
  std::array<std::array<std::uint64_t, 2>, kRules> before;
  for (std::size_t n = 0; n < kRules; ++n)
    before[n] = {report_.rules[n].violated, report_.rules[n].undecided};
  for (const Finding& f : later.report_.findings) {
    std::uint64_t& number = before[static_cast<std::size_t>(f.rule)][f.outcome == Outcome::violated ? 0 : 1];
    if (number++ < max_reports_) report_.findings.push_back(f);
  }
  for (std::size_t n = 0; n < kRules; ++n) {
    RuleResult& all = report_.rules[n];
    const RuleResult& more = later.report_.rules[n];
    all.passed += more.passed;
    all.violated += more.violated;
    all.undecided += more.undecided;
    all.vague += more.vague;
    if (!(more.worst > all.worst)) continue;
    all.worst = more.worst;
    all.worst_off = more.worst_off;
    all.worst_allowed = more.worst_allowed;
  }
  for (const auto& [rule, why] : later.reasons_) not_judged(rule, why);
  vague_.insert(later.vague_.begin(), later.vague_.end());
  for (std::size_t n = 0; n < residuals_.size(); ++n) residuals_[n].take_over(later.residuals_[n]);
  report_.events += later.report_.events;
  report_.states += later.report_.states;
  report_.segments += later.report_.segments;
  if (!later.report_.end.empty()) report_.end = later.report_.end;
}

}  // namespace tps::check
