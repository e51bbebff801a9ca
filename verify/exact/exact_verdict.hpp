// The exact verdict of a timing query: filters in front, integers behind.
#pragma once

#include "verify/exact/counters.hpp"
#include "verify/exact/double_filter.hpp"
#include "verify/exact/plane_query.hpp"
#include "verify/exact/timing_query.hpp"
#include "verify/exact/verdict.hpp"

namespace tps::exact {

/// A verdict, and the best coefficients that the stages so far have seen.
struct VerdictWithCoefficients {
  Verdict verdict;
  Coefficients coefficients;     ///< in_range is false where only integers could answer
  bool in_double_words = false;  ///< the coefficients are those of stage 2
};

/// Stages 2 and 3, for a query that stage 1 left open. REQUIRES a valid query with v ≠ 0.
VerdictWithCoefficients escalated_verdict(const TimingQuery& query, Counters& counters);

/// The verdict that real arithmetic gives on the stored doubles (semantics §1), over their whole range.
///
/// REQUIRES valid(query). Laws:
///   (1) the verdict is that of the integers, whatever stage answered;
///   (2) exchanging A and B changes nothing;
///   (3) 2^k (u, L) and 2^m v have the same verdict, wherever they are doubles;
///   (4) a common offset added exactly to both positions, or to both velocities, changes nothing.
inline VerdictWithCoefficients verdict_with_coefficients(const TimingQuery& query, Counters& counters) {
  if (query.kind == Kind::plane) return {plane_verdict(query, counters), {}};
  ++counters.verdict.calls;
  const Coefficients coefficients = double_coefficients(query);
  const std::optional<Verdict> verdict = coefficients.verdict(query.kind);
  if (verdict) return {*verdict, coefficients};
  if (is_static(query)) return {Verdict::static_pair, coefficients};
  return escalated_verdict(query, counters);
}

inline Verdict exact_verdict(const TimingQuery& query, Counters& counters) {
  return verdict_with_coefficients(query, counters).verdict;
}

}  // namespace tps::exact
