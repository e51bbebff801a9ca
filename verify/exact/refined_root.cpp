#include "verify/exact/refined_root.hpp"

#include <cmath>

#include "verify/exact/double_word_filter.hpp"

namespace tps::exact {
namespace {

constexpr double u = unit_roundoff;
/// Second-order terms of the bounds are worth 1.01 below this.
constexpr double small = 0x1p-20;

/// The relative state at a double time, w = r + v t, with the sums that bounds are made of. Its double words
/// are not normalised: |w.lo| ≤ 3u B.
struct StateAt {
  std::array<DoubleWord, 3> v, w;
  double B;    ///< Σ |r_k| + |v_k t|
  double V;    ///< Σ |v_k|
  double v_w;  ///< Σ v_k w_k in double
};

TPS_IN_EVERY_COPY StateAt state_at(const TimingQuery& query, double t) {
  const std::array<DoubleWord, 3> r = relative_position(query);
  StateAt state{exact_difference(query.v_B, query.v_A), {}, 0, 0, 0};
  for (std::size_t k = 0; k < 3; ++k) {
    const DoubleWord& v = state.v[k];
    const DoubleWord step = two_product(v.hi, t);
    const DoubleWord high = two_sum(r[k].hi, step.hi);
    const double low = (r[k].lo + high.lo) + __builtin_fma(v.lo, t, step.lo);
    state.w[k] = {high.hi, low};
    state.B += std::fabs(r[k].hi) + std::fabs(step.hi);
    state.V += std::fabs(v.hi);
    state.v_w += v.hi * (high.hi + low);
  }
  return state;
}

TPS_IN_EVERY_COPY std::optional<RefinedTime> refined_hit(const TimingQuery& query, const StateAt& at,
                                                         double t) {
  std::array<double, 3> high, low;
  for (std::size_t k = 0; k < 3; ++k) {
    const DoubleWord square = two_product(at.w[k].hi, at.w[k].hi);
    high[k] = square.hi;
    low[k] = square.lo + at.w[k].lo * (2 * at.w[k].hi + at.w[k].lo);
  }
  const DoubleWord two = two_sum(high[0], high[1]);
  const DoubleWord three = two_sum(two.hi, high[2]);
  const DoubleWord L_squared = two_product(query.L, query.L);
  const double apart = three.hi - L_squared.hi;
  const double q0 = apart + (((low[0] + low[1]) + low[2]) + ((two.lo + three.lo) - L_squared.lo));
  const double w = 1.12 * query.L;  // |w| is not above
  const double wide = widening(query);
  const double q0_error =
      wide * u * u * (52 * w * at.B + 14 * w * w + 104 * u * at.B * at.B) + underflow_allowance;
  const double q1 = 2 * at.v_w;
  const double q1_error = wide * 2 * u * at.V * (6 * w + 24 * u * at.B) + underflow_allowance;

  // The slope is negative before closest approach, where blocking happens, and positive after it.
  const bool right_side = query.kind == Kind::block ? q1 < 0 : q1 > 0;
  const double inverse_slope = 1 / q1;
  const double per_slope = std::fabs(inverse_slope);
  const double correction = -q0 * inverse_slope;
  const double residual_uncertainty = 1.01 * q0_error * per_slope;
  const double size = std::fabs(correction) + residual_uncertainty;
  const double slope_uncertainty = q1_error * per_slope;
  const double curvature = at.V * at.V * size * per_slope;
  const bool bounded = slope_uncertainty < small && 4 * curvature < small;
  // Near the root |w| is near L: then the difference of their squares is exact (Sterbenz).
  const bool is_exact = std::fabs(apart) < 0.25 * L_squared.hi;
  const bool in_range = comfortable(L_squared.hi) && comfortable(at.V * at.V);
  if (!(right_side && bounded && in_range && is_exact)) return std::nullopt;
  return RefinedTime{t, correction,
                     residual_uncertainty + size * (1.01 * slope_uncertainty + 8 * u + 1.1 * curvature) +
                         underflow_allowance};
}

/// Closest approach: v·w = 0, linear in t.
TPS_IN_EVERY_COPY std::optional<RefinedTime> refined_turning(const TimingQuery& query, const StateAt& at,
                                                             double t) {
  const DoubleWord parts = dot(at.v, at.w);
  const double rho = parts.hi + parts.lo;
  double v_w = 0, v_squared = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    v_w += std::fabs(at.v[k].hi * at.w[k].hi);
    v_squared += at.v[k].hi * at.v[k].hi;
  }
  const double rho_error = widening(query) * u * u * (27 * at.V * at.B + 15 * v_w) + underflow_allowance;
  const double correction = -rho / v_squared;
  if (!comfortable(v_squared)) return std::nullopt;
  return RefinedTime{t, correction,
                     1.01 * rho_error / v_squared + 10 * u * std::fabs(correction) + underflow_allowance};
}

}  // namespace

std::optional<double> RefinedTime::rounded() const {
  // The sums below are rounded once each; widening by 4u of the sum covers that, and the last addition is the
  // rounding that is asked for.
  const double widened = error + 4 * u * (std::fabs(correction) + error);
  const double low = t + (correction - widened);
  const double high = t + (correction + widened);
  if (low == high) return low;
  return std::nullopt;
}

double approximate_time(Kind kind, Verdict verdict, const Coefficients& q) {
  if (verdict == Verdict::turning) return -q.h / q.a;
  const double root = std::sqrt(q.D);
  if (kind == Kind::block) return q.c / (root - q.h);
  return q.h <= 0 ? (root - q.h) / q.a : -q.c / (root + q.h);
}

TPS_WITH_FMA std::optional<RefinedTime> refined_time(const TimingQuery& query, Verdict verdict, double t) {
  // Smaller or larger times would let products with v underflow or overflow unnoticed.
  if (!(t > 0x1p-500 && t < 0x1p500)) return std::nullopt;
  const StateAt at = state_at(query, t);
  return verdict == Verdict::turning ? refined_turning(query, at, t) : refined_hit(query, at, t);
}

}  // namespace tps::exact
