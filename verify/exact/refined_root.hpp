// The correctly rounded time, fast path: one Newton step from a double, with its residual in double words and
// a proven bound on the error (docs/exact.md, "The time").
#pragma once

#include <optional>

#include "verify/exact/double_filter.hpp"
#include "verify/exact/double_word_filter.hpp"
#include "verify/exact/timing_query.hpp"
#include "verify/exact/verdict.hpp"

namespace tps::exact {

/// A time t̂ + δ within ± error.
struct RefinedTime {
  double t, correction, error;

  /// The rounding test: the double that every number in t̂ + δ ± error rounds to, if there is one.
  std::optional<double> rounded() const;
};

/// A double near the time of a `hit` or `turning` query, by the formulas without cancellation.
/// REQUIRES coefficients in range, and D > 0 for a hit.
double approximate_time(Kind kind, Verdict verdict, const Coefficients& coefficients);

/// The time of a `hit` (the root on the kind's side of closest approach) or `turning` query near t.
/// @return nullopt where the bound does not hold: out of range, or t not on the root's side.
/// Law: the exact time lies in t + correction ± error.
std::optional<RefinedTime> refined_time(const TimingQuery& query, Verdict verdict, double t);

}  // namespace tps::exact
