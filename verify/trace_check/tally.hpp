// Where the rules put their verdicts: counts and margins for each rule, the first findings in full.
#pragma once

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "verify/trace_check/lazy_table.hpp"
#include "verify/trace_check/report.hpp"
#include "verify/trace_check/residuals.hpp"

namespace tps::check {

/// Of what residuals are added up, in the order of the reports.
enum class Quantity : std::size_t { energy, momentum, time };
inline constexpr std::array<const char*, 3> kQuantities = {"energy", "momentum", "time"};

/// The step that is being judged.
struct Step {
  std::uint64_t line = 0;
  std::uint64_t event = 0;
  std::string_view t;  ///< as the line spells it, which is not read again meanwhile
  std::vector<std::int32_t> particles;

  void begin(std::uint64_t line_now, std::uint64_t event_now = 0) {
    line = line_now;
    event = event_now;
    t = {};
    particles.clear();
  }
};

class Tally {
 public:
  Tally(CheckReport& report, double tolerance, std::uint64_t max_reports)
      : report_(report), tolerance_(tolerance), max_reports_(max_reports) {}

  Step step;

  double tolerance() const { return tolerance_; }
  void pass(Rule rule) { ++of(rule).passed; }

  /// Judges a residual of `off` ulps by a bound of `allowed` ulps, times the tolerance; `describe` completes
  /// the finding where it is beyond. @return whether it is within.
  template <typename Describe>
  bool within(Rule rule, double off, double allowed, Describe describe) {
    const double bound = allowed * tolerance_;
    if (off <= bound) {
      RuleResult& result = of(rule);
      ++result.passed;
      if (bound > 0 && off / bound > result.worst) {
        result.worst = off / bound;
        result.worst_off = off;
        result.worst_allowed = bound;
      }
      return true;
    }
    Finding finding;
    finding.off = off;
    finding.allowed = bound;
    add(rule, Outcome::violated, finding, describe);
    return false;
  }

  /// Judges what is either so or not.
  template <typename Describe>
  bool demand(Rule rule, bool holds, Describe describe) {
    if (holds) {
      pass(rule);
      return true;
    }
    add(rule, Outcome::violated, {}, describe);
    return false;
  }

  template <typename Describe>
  void undecided(Rule rule, Describe describe) {
    add(rule, Outcome::undecided, {}, describe);
  }

  /// Something to know about the trace as a whole.
  void note(std::string text) { report_.notes.push_back(std::move(text)); }
  /// What of a rule could not be judged, each reason once.
  void not_judged(Rule rule, const std::string& why) {
    std::string& said = of(rule).not_judged;
    if (said.find(why) != std::string::npos) return;
    said += (said.empty() ? "" : "; ") + why;
    reasons_.emplace_back(rule, why);
  }

  /// A step that the rule cannot judge, since its margin is larger than what it judges. Said once, with the
  /// first place and the number of steps.
  template <typename Why>
  void cannot_tell(Rule rule, Why why) {
    if (of(rule).vague++ > 0) return;
    vague_[rule] = fmt::format("first at line {}, {}", step.line, why());
  }

  /// Adds a residual y that is expected to be rounding of size 1; of a bias of one ulp it would have x. Like
  /// events have nearly the same `size`.
  void residual(Quantity quantity, double size, double y, double x = 1) {
    if (std::isfinite(x * y)) residuals_[static_cast<std::size_t>(quantity)].add(y, x, size);
  }
  /// What will probably be asked and added soon: no cache holds all places of either.
  void expect_residual(Quantity quantity, double size) const {
    residuals_[static_cast<std::size_t>(quantity)].expect(size);
  }
  void expect_asked(double x) const { seen_.fetch(place_of(x)); }
  void close_sums();

  /// Takes over the verdicts on the segment of the trace behind what this one is of, as if they had been
  /// given here; sums of residuals are added up a segment at a time.
  void take_over(const Tally& later);

  /// Whether a number was among the last ones asked for: motions that repeat repeat their roundings.
  bool seen_before(double x) {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    return std::exchange(seen_[place_of(x)], bits) == bits;
  }

 private:
  static std::uint16_t place_of(double x) {
    return static_cast<std::uint16_t>((std::bit_cast<std::uint64_t>(x) * 0x9e3779b97f4a7c15U) >> 48U);
  }
  RuleResult& of(Rule rule) { return report_.rules[static_cast<std::size_t>(rule)]; }

  template <typename Describe>
  void add(Rule rule, Outcome outcome, Finding finding, Describe describe) {
    RuleResult& result = of(rule);
    const std::uint64_t before = outcome == Outcome::violated ? result.violated++ : result.undecided++;
    if (before >= max_reports_) return;
    finding.rule = rule;
    finding.outcome = outcome;
    finding.line = step.line;
    finding.event = step.event;
    finding.t = step.t;
    finding.particles = step.particles;
    describe(finding);
    report_.findings.push_back(std::move(finding));
  }

  CheckReport& report_;
  double tolerance_;
  std::uint64_t max_reports_;
  std::array<Residuals, kQuantities.size()> residuals_;
  std::map<Rule, std::string> vague_;
  std::vector<std::pair<Rule, std::string>> reasons_;  ///< why something was not judged, as it came
  LazyTable<std::uint64_t> seen_;
};

}  // namespace tps::check
