#include "verify/exact/rounded_time.hpp"

#include <algorithm>

#include "verify/exact/double_word_filter.hpp"
#include "verify/exact/exact_root.hpp"
#include "verify/exact/exact_verdict.hpp"
#include "verify/exact/modular_query.hpp"
#include "verify/exact/plane_query.hpp"
#include "verify/exact/plane_time.hpp"
#include "verify/exact/refined_root.hpp"

namespace tps::exact {
namespace {

/// The rounded time by one Newton step, or a second one where the first double was poor: from the first's
/// result if that has a bound, else (next to a graze, where D has lost its digits) from coefficients in
/// double words.
std::optional<double> fast_time(const TimingQuery& query, const VerdictWithCoefficients& known,
                                Counters& counters) {
  if (!known.coefficients.in_range) {
    ++counters.time.uncertain;
    return std::nullopt;
  }
  const double t = approximate_time(query.kind, known.verdict, known.coefficients);
  const std::optional<RefinedTime> once = refined_time(query, known.verdict, t);
  if (once) {
    const std::optional<double> rounded = once->rounded();
    if (rounded) return rounded;
  }
  ++counters.time.uncertain;
  if (!once && known.in_double_words) return std::nullopt;  // there are no better ones
  const double better = once ? once->t + once->correction
                             : approximate_time(query.kind, known.verdict, double_word_coefficients(query));
  const std::optional<RefinedTime> twice = refined_time(query, known.verdict, better);
  return twice ? twice->rounded() : std::nullopt;
}

/// The same where double words bound the integers of the query.
std::optional<double> modular_time(const TimingQuery& query, const VerdictWithCoefficients& known,
                                   Counters& counters) {
  const std::optional<ModularQuadratic> quadratic =
      modular_quadratic(query, known.in_double_words ? known.coefficients : double_word_coefficients(query));
  if (!quadratic) return std::nullopt;
  counters.largest_bits = std::max<std::uint64_t>(counters.largest_bits, ModularInteger::kBits);
  return rounded_time(query.kind, known.verdict, *quadratic);
}

double time_by_integers(const TimingQuery& query, Verdict verdict, Counters& counters) {
  if (query.kind == Kind::plane) return rounded(plane_time(query, units_of(query)), 0);
  const LiftedQuadratic quadratic = lifted_quadratic(query, units_of(query));
  counters.largest_bits = std::max(counters.largest_bits, largest_bits(quadratic));
  return rounded(algebraic_time(query.kind, verdict, quadratic), quadratic.c);
}

TimingAnswer time_of(const TimingQuery& query, const VerdictWithCoefficients& known, Counters& counters) {
  if (!occurs(known.verdict)) return {known.verdict, std::nullopt};
  ++counters.time.calls;
  if (at_once(known.verdict)) return {known.verdict, 0.0};
  if (query.kind == Kind::plane) {
    const std::optional<RefinedTime> refined = refined_plane_time(query);
    const std::optional<double> rounded = refined ? refined->rounded() : std::nullopt;
    if (rounded) return {known.verdict, rounded};
    ++counters.time.uncertain;
    ++counters.time.exact;
    return {known.verdict, time_by_integers(query, known.verdict, counters)};
  }
  const std::optional<double> fast = fast_time(query, known, counters);
  if (fast) return {known.verdict, fast};
  ++counters.time.exact;
  const std::optional<double> modular = modular_time(query, known, counters);
  return {known.verdict, modular ? *modular : time_by_integers(query, known.verdict, counters)};
}

}  // namespace

TimingAnswer rounded_time(const TimingQuery& query, Counters& counters) {
  return time_of(query, verdict_with_coefficients(query, counters), counters);
}

KnownTime known_time(const TimingQuery& query, Counters& counters) {
  const VerdictWithCoefficients known = verdict_with_coefficients(query, counters);
  return {time_of(query, known, counters), known};
}

TimingAnswer rounded_time_by_integers(const TimingQuery& query, Counters& counters) {
  if (is_static(query)) return {Verdict::static_pair, std::nullopt};
  if (query.kind == Kind::plane) {
    const Verdict verdict = plane_verdict(query, counters);
    if (!occurs(verdict)) return {verdict, std::nullopt};
    return {verdict, at_once(verdict) ? 0.0 : time_by_integers(query, verdict, counters)};
  }
  const Verdict verdict = verdict_of(query.kind, lifted_quadratic(query, units_of(query)));
  if (!occurs(verdict)) return {verdict, std::nullopt};
  return {verdict, time_by_integers(query, verdict, counters)};
}

}  // namespace tps::exact
