#include "verify/exact/rounded_time.hpp"

#include <algorithm>

#include "verify/exact/exact_root.hpp"
#include "verify/exact/exact_verdict.hpp"
#include "verify/exact/refined_root.hpp"

namespace tps::exact {
namespace {

/// The rounded time by at most two Newton steps; the second serves where the first double was poor.
std::optional<double> fast_time(const TimingQuery& query, const VerdictWithCoefficients& known) {
  if (!known.coefficients.in_range) return std::nullopt;
  double t = approximate_time(query.kind, known.verdict, known.coefficients);
  for (int step = 0; step < 2; ++step) {
    const std::optional<RefinedTime> refined = refined_time(query, known.verdict, t);
    if (!refined) return std::nullopt;
    const std::optional<double> rounded = refined->rounded();
    if (rounded) return rounded;
    t += refined->correction;
  }
  return std::nullopt;
}

double time_by_integers(const TimingQuery& query, Verdict verdict, Counters& counters) {
  const LiftedQuadratic quadratic = lifted_quadratic(query, units_of(query));
  counters.largest_bits = std::max(counters.largest_bits, largest_bits(quadratic));
  return rounded(algebraic_time(query.kind, verdict, quadratic), quadratic.c);
}

}  // namespace

TimingAnswer rounded_time(const TimingQuery& query, Counters& counters) {
  const VerdictWithCoefficients known = verdict_with_coefficients(query, counters);
  if (!occurs(known.verdict)) return {known.verdict, std::nullopt};
  ++counters.time.calls;
  if (at_once(known.verdict)) return {known.verdict, 0.0};
  const std::optional<double> fast = fast_time(query, known);
  if (fast) return {known.verdict, fast};
  ++counters.time.uncertain;
  ++counters.time.exact;
  return {known.verdict, time_by_integers(query, known.verdict, counters)};
}

TimingAnswer rounded_time_by_integers(const TimingQuery& query, Counters& counters) {
  if (is_static(query)) return {Verdict::static_pair, std::nullopt};
  const Verdict verdict = verdict_of(query.kind, lifted_quadratic(query, units_of(query)));
  if (!occurs(verdict)) return {verdict, std::nullopt};
  return {verdict, time_by_integers(query, verdict, counters)};
}

}  // namespace tps::exact
