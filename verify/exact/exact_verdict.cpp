#include "verify/exact/exact_verdict.hpp"

#include <algorithm>

#include "verify/exact/double_word_filter.hpp"
#include "verify/exact/lifted_query.hpp"
#include "verify/exact/modular_query.hpp"

namespace tps::exact {

VerdictWithCoefficients escalated_verdict(const TimingQuery& query, Counters& counters) {
  ++counters.verdict.uncertain;
  const Coefficients coefficients = double_word_coefficients(query);
  const std::optional<Verdict> verdict = coefficients.verdict(query.kind);
  if (verdict) return {*verdict, coefficients, true};

  ++counters.verdict.exact;
  if (const std::optional<ModularQuadratic> modular = modular_quadratic(query, coefficients)) {
    counters.largest_bits = std::max<std::uint64_t>(counters.largest_bits, ModularInteger::kBits);
    return {verdict_of(query.kind, *modular), coefficients, true};
  }
  const LiftedQuadratic quadratic = lifted_quadratic(query, units_of(query));
  counters.largest_bits = std::max(counters.largest_bits, largest_bits(quadratic));
  return {verdict_of(query.kind, quadratic), coefficients, true};
}

}  // namespace tps::exact
