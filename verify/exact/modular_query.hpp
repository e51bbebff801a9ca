// Stage 3 where double words have bounded what they could not decide: integers modulo 2^256
// (docs/exact.md, "Integers of 256 bits").
#pragma once

#include <optional>

#include "verify/exact/double_filter.hpp"
#include "verify/exact/modular_integer.hpp"
#include "verify/exact/timing_query.hpp"
#include "verify/exact/verdict.hpp"

namespace tps::exact {

/// The quadratic a t² + 2 h t + c = 0 in integers, with t in units of 2^time_exponent.
struct ModularQuadratic {
  ModularInteger a, h, c, D;
  int time_exponent;
};

/// Exactly the query's quadratic, of which `bounds` says that each number has at most 255 bits in the query's
/// units; nothing where it does not. REQUIRES a valid query with v ≠ 0.
/// Law: the numbers are those of lifted_quadratic.
std::optional<ModularQuadratic> modular_quadratic(const TimingQuery& query, const Coefficients& bounds);

Verdict verdict_of(Kind kind, const ModularQuadratic& quadratic);

/// The time of a query that occurs, but not at once, rounded to the nearest double; nothing where double
/// words cannot tell which that is. Law: the time is the rounding of the real number.
std::optional<double> rounded_time(Kind kind, Verdict verdict, const ModularQuadratic& quadratic);

}  // namespace tps::exact
