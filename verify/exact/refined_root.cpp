#include "verify/exact/refined_root.hpp"

#include <cmath>

#include "verify/exact/double_word_filter.hpp"

namespace tps::exact {
namespace {

constexpr double u = unit_roundoff;
/// Second-order terms of the bounds are worth 1.01 below this.
constexpr double small = 0x1p-20;

/// The relative state at a double time: w = r + v t in double words, with the sums that bounds are made of.
struct StateAt {
  std::array<DoubleWord, 3> v, w;
  double v_w;           ///< Σ v_k w_k in double
  double v_w_absolute;  ///< Σ |v_k w_k|
  double w_B, v_B;      ///< Σ (|w_k| + 8u² B_k) B_k and Σ |v_k| B_k with B_k = |r_k| + |v_k t|
  double v_squared;     ///< a
};

TPS_IN_EVERY_COPY StateAt state_at(const TimingQuery& query, double t) {
  const std::array<DoubleWord, 3> r = relative_position(query);
  StateAt state{exact_difference(query.v_B, query.v_A), {}, 0, 0, 0, 0, 0};
  for (std::size_t k = 0; k < 3; ++k) {
    const DoubleWord& v = state.v[k];
    const DoubleWord step = v * t;
    state.w[k] = r[k] + step;
    const double B = std::fabs(r[k].hi) + std::fabs(step.hi);
    const double product = v.hi * state.w[k].hi;
    state.v_w += product;
    state.v_w_absolute += std::fabs(product);
    state.w_B += (std::fabs(state.w[k].hi) + 8 * u * u * B) * B;
    state.v_B += std::fabs(v.hi) * B;
    state.v_squared += v.hi * v.hi;
  }
  return state;
}

TPS_IN_EVERY_COPY std::optional<RefinedTime> refined_hit(const TimingQuery& query, const StateAt& at,
                                                         double t) {
  const DoubleWord w_squared = at.w[0] * at.w[0] + at.w[1] * at.w[1] + at.w[2] * at.w[2];
  const DoubleWord L_squared = two_product(query.L, query.L);
  const double q0 = (w_squared - L_squared).hi;
  const double q0_error =
      widening(query) * u * u * (11 * at.w_B + 16 * w_squared.hi + 4 * L_squared.hi) + underflow_allowance;
  const double q1 = 2 * at.v_w;
  const double q1_error =
      widening(query) * 2 * (6 * u * at.v_w_absolute + 6 * u * u * at.v_B) + underflow_allowance;

  // The slope is negative before closest approach, where blocking happens, and positive after it.
  const bool right_side = query.kind == Kind::block ? q1 < 0 : q1 > 0;
  const double per_slope = 1 / std::fabs(q1);
  const double correction = -q0 / q1;
  const double residual_uncertainty = 1.01 * q0_error * per_slope;
  const double size = std::fabs(correction) + residual_uncertainty;
  const double slope_uncertainty = q1_error * per_slope;
  const double curvature = at.v_squared * size * per_slope;
  const bool bounded = slope_uncertainty < small && 4 * curvature < small;
  const bool in_range = comfortable(L_squared.hi) && comfortable(at.v_squared) && comfortable(w_squared.hi);
  if (!(right_side && bounded && in_range)) return std::nullopt;
  return RefinedTime{t, correction,
                     residual_uncertainty + size * (1.01 * slope_uncertainty + 8 * u + 1.1 * curvature) +
                         underflow_allowance};
}

/// Closest approach: v·w = 0, linear in t.
TPS_IN_EVERY_COPY std::optional<RefinedTime> refined_turning(const TimingQuery& query, const StateAt& at,
                                                             double t) {
  const double rho = (at.v[0] * at.w[0] + at.v[1] * at.w[1] + at.v[2] * at.w[2]).hi;
  const double rho_error =
      widening(query) * u * u * (6 * at.v_B + 12 * at.v_w_absolute) + underflow_allowance;
  const double correction = -rho / at.v_squared;
  if (!comfortable(at.v_squared)) return std::nullopt;
  return RefinedTime{t, correction,
                     1.01 * rho_error / at.v_squared + 10 * u * std::fabs(correction) + underflow_allowance};
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
