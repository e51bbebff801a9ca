// Stage 1 of the order: a time in double with a bound on its error (docs/exact.md, "The order").
#pragma once

#include <cmath>

#include "verify/exact/double_filter.hpp"
#include "verify/exact/verdict.hpp"

namespace tps::exact {

/// A time within t ± error; a NaN in either is in no order with anything.
struct BoundedTime {
  double t, error;
};

/// The time of an event whose verdict is certain, from the coefficients of stage 1 or 2.
/// REQUIRES occurs(verdict), coefficients in range.
/// Law: the exact time lies in t ± error.
inline BoundedTime bounded_time(Kind kind, Verdict verdict, const Coefficients& q) {
  constexpr double u = unit_roundoff;
  constexpr double small = 0x1p-10;  // below it, terms of second order are within the factors 1.01
  if (at_once(verdict)) return {0, 0};
  const double h_size = std::fabs(q.h);
  if (verdict == Verdict::turning) {
    const double t = h_size / q.a;
    return {t, q.h_error / q.a * 1.01 + 10 * u * t + underflow_allowance};
  }
  const double root = std::sqrt(q.D);
  const double sum = h_size + root;
  const double sum_error = (q.h_error + q.D_error / root + u * root) / sum;  // relative
  // A tether's h near zero may be computed with the wrong sign: both forms hold for either sign, and the
  // chosen one does not cancel.
  const bool quotient_of_c = kind == Kind::block || q.h > 0;
  const double c_size = std::fabs(q.c);
  const double t = quotient_of_c ? c_size / sum : sum / q.a;
  const double other_error = quotient_of_c ? q.c_error / c_size : 6 * u;  // relative
  // 3u for the operations; as much for h, c and D that come from double words, rounded.
  const double relative = 1.01 * (sum_error + other_error + 8 * u);
  if (!(relative < small && t > 0x1p-500 && t < 0x1p500)) return {t, HUGE_VAL};
  return {t, relative * t};
}

}  // namespace tps::exact
