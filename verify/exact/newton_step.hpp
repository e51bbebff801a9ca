// One step of Newton towards the time of a hit, with a bound on what it leaves (docs/exact.md, "The time").
// One formula for one query and for several at once: T is double, or Four (four_doubles.hpp).
#pragma once

#include <array>
#include <cmath>

#include "verify/exact/double_filter.hpp"
#include "verify/exact/double_word.hpp"
#include "verify/exact/double_word_filter.hpp"

namespace tps::exact {

TPS_IN_EVERY_COPY double square_root(double x) {
  return std::sqrt(x);
}
TPS_IN_EVERY_COPY double either(bool first, double x, double y) {
  return first ? x : y;
}

/// |c|/(|h| + √D) or (|h| + √D)/a, whichever does not cancel. REQUIRES a hit by its signs, D > 0.
/// @param side of closest approach: −1 before it (blocking), 1 after it (tethering)
template <typename T>
TPS_IN_EVERY_COPY T approximate_hit(const CoefficientsIn<T>& q, T side) {
  const Truth<T> by_c = (side < T(0)) | (q.h > T(0));
  const T sum = absolute(q.h) + square_root(q.D);
  return either(by_c, absolute(q.c), sum) / either(by_c, sum, q.a);
}

/// The relative state at a double time, w = r + v t, along one axis, with the terms that bounds are made of.
/// Its words are not normalised: |w.lo| ≤ 3u size.
template <typename T>
struct AlongAxis {
  Words<T> v, w;
  T size;   ///< |r| + |v t|
  T speed;  ///< |v|
  T v_w;    ///< v w in double
};

template <typename T>
TPS_IN_EVERY_COPY AlongAxis<T> along_axis(Words<T> r, Words<T> v, T t) {
  const Words<T> step = two_product(v.hi, t);
  const Words<T> high = two_sum(r.hi, step.hi);
  const T low = (r.lo + high.lo) + multiply_add(v.lo, t, step.lo);
  return {v, {high.hi, low}, absolute(r.hi) + absolute(step.hi), absolute(v.hi), v.hi * (high.hi + low)};
}

template <typename T>
struct StateAt {
  std::array<Words<T>, 3> v, w;
  T B;    ///< Σ |r_k| + |v_k t|
  T V;    ///< Σ |v_k|
  T v_w;  ///< Σ v_k w_k in double
};

template <typename T>
TPS_IN_EVERY_COPY StateAt<T> state_at(const std::array<Words<T>, 3>& r, const std::array<Words<T>, 3>& v,
                                      T t) {
  const AlongAxis<T> x = along_axis(r[0], v[0], t), y = along_axis(r[1], v[1], t),
                     z = along_axis(r[2], v[2], t);
  return {v, {x.w, y.w, z.w}, x.size + y.size + z.size, x.speed + y.speed + z.speed, x.v_w + y.v_w + z.v_w};
}

/// Closest approach, where v·w = 0.
template <typename T>
TPS_IN_EVERY_COPY T approximate_turning(const CoefficientsIn<T>& q) {
  return -q.h / q.a;
}

/// The exact time lies in t + correction ± error where `holds`.
template <typename T>
struct NewtonStep {
  T correction, error;
  Truth<T> holds;
};

/// x², its low part in double and not normalised.
template <typename T>
TPS_IN_EVERY_COPY Words<T> rough_square(Words<T> x) {
  const Words<T> square = two_product(x.hi, x.hi);
  return {square.hi, square.lo + x.lo * (2 * x.hi + x.lo)};
}

/// @param side as in approximate_hit()
/// @param wide by how much bounds are wider that count r as exact
template <typename T>
TPS_IN_EVERY_COPY NewtonStep<T> step_to_hit(const StateAt<T>& at, T L, T side, T wide) {
  constexpr double u = unit_roundoff;
  constexpr double small = 0x1p-20;  // second-order terms of the bounds are worth 1.01 below this
  const Words<T> x = rough_square(at.w[0]), y = rough_square(at.w[1]), z = rough_square(at.w[2]);
  const Words<T> two = two_sum(x.hi, y.hi);
  const Words<T> three = two_sum(two.hi, z.hi);
  const Words<T> L_squared = two_product(L, L);
  const T apart = three.hi - L_squared.hi;
  const T q0 = apart + (((x.lo + y.lo) + z.lo) + ((two.lo + three.lo) - L_squared.lo));
  const T w = 1.12 * L;  // |w| is not above
  const T q0_error =
      wide * u * u * (52 * w * at.B + 14 * w * w + 104 * u * at.B * at.B) + T(underflow_allowance);
  const T q1 = 2 * at.v_w;
  const T q1_error = wide * 2 * u * at.V * (6 * w + 24 * u * at.B) + T(underflow_allowance);

  const T inverse_slope = T(1) / q1;
  const T per_slope = absolute(inverse_slope);
  const T correction = -q0 * inverse_slope;
  const T residual_uncertainty = 1.01 * q0_error * per_slope;
  const T size = absolute(correction) + residual_uncertainty;
  const T slope_uncertainty = q1_error * per_slope;
  const T V_squared = at.V * at.V;
  const T curvature = V_squared * size * per_slope;
  const Truth<T> bounded = (slope_uncertainty < T(small)) & (4 * curvature < T(small));
  // Near the root |w| is near L: then the difference of their squares is exact (Sterbenz).
  const Truth<T> is_exact = absolute(apart) < 0.25 * L_squared.hi;
  const Truth<T> in_range = both(comfortable(L_squared.hi), comfortable(V_squared));
  const Truth<T> on_its_side = side * q1 > T(0);
  const Truth<T> holds = on_its_side & bounded & in_range & is_exact;
  const T error = residual_uncertainty + size * (1.01 * slope_uncertainty + 8 * u + 1.1 * curvature) +
                  T(underflow_allowance);
  return {correction, error, holds};
}

/// The same to closest approach: v·w = 0, linear in t.
template <typename T>
TPS_IN_EVERY_COPY NewtonStep<T> step_to_turning(const StateAt<T>& at, T wide) {
  constexpr double u = unit_roundoff;
  const Words<T> parts = dot(at.v, at.w);
  const T rho = parts.hi + parts.lo;
  const T v_w = absolute(at.v[0].hi * at.w[0].hi) + absolute(at.v[1].hi * at.w[1].hi) +
                absolute(at.v[2].hi * at.w[2].hi);
  const T v_squared = at.v[0].hi * at.v[0].hi + at.v[1].hi * at.v[1].hi + at.v[2].hi * at.v[2].hi;
  const T rho_error = wide * u * u * (27 * at.V * at.B + 15 * v_w) + T(underflow_allowance);
  const T correction = -rho / v_squared;
  const T error = 1.01 * rho_error / v_squared + 10 * u * absolute(correction) + T(underflow_allowance);
  return {correction, error, comfortable(v_squared)};
}

/// Every number in t + correction ± error rounds to one double if these two are equal.
template <typename T>
struct RoundedEnds {
  T low, high;
};

template <typename T>
TPS_IN_EVERY_COPY RoundedEnds<T> rounded_ends(T t, T correction, T error) {
  // The sums below are rounded once each; widening by 4u of the sum covers that, and the last addition is the
  // rounding that is asked for.
  const T widened = error + 4 * unit_roundoff * (absolute(correction) + error);
  return {t + (correction - widened), t + (correction + widened)};
}

/// Whether no product with v over- or underflows unnoticed.
template <typename T>
TPS_IN_EVERY_COPY Truth<T> usual_size(T t) {
  return (t > T(0x1p-500)) & (t < T(0x1p500));
}

}  // namespace tps::exact
