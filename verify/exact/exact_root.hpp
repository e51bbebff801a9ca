// Times as algebraic numbers (P ± √D)/a over the integers: where a rational lies beside one, and its correct
// rounding.
#pragma once

#include "verify/exact/lifted_query.hpp"

namespace tps::exact {

/// t = (−h + side √D) / a in units of 2^time_exponent, a > 0, D ≥ 0. Rational times have side = 0.
struct AlgebraicTime {
  Integer a, h, D;
  int side;  ///< −1: the smaller root, +1: the larger, 0: closest approach (or t = 0)
  int time_exponent;
};

/// The time of a query that occurs. REQUIRES occurs(verdict).
AlgebraicTime algebraic_time(Kind kind, Verdict verdict, const LiftedQuadratic& quadratic);

/// The double nearest to t, ties to even; infinity beyond the largest, subnormals and zero below the
/// smallest. REQUIRES t ≥ 0, and quadratic.c consistent with a, h, D.
double rounded(const AlgebraicTime& time, const Integer& c);

}  // namespace tps::exact
