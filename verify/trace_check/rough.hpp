// What friction adds to a rebound (Walton; docs/effects.md), and how far an evaluation may be from it
// (docs/check.md, "Friction").
#pragma once

#include "verify/trace_check/responses.hpp"

namespace tps::check {

/// I/(m R²).
template <typename W>
W inertia_ratio(int dimension) {
  return dimension == 2 ? W(1) / W(2) : W(2) / W(5);
}

template <typename W>
struct Rough {
  Vec<W> dp;  ///< J_t on i, along g_t
  W error;    ///< all of it
  bool sticks;
  bool boundary;  ///< rounding decides whether it does
  W lost;         ///< energy: J_t (|g_t| − J_t/2κm)
};

/// J_t = min(μ |J_n|, κ (1 + β₀) m |g_t|), g_t = v_ŵ − S × û, S = R_i ω_i + R_j ω_j.
///
/// With G = |v| + |S|-sizes σ: v_ŵ errs by 16u |v|, S × û by 11u σ, so g_t by 18u G; what multiplies it in κ
/// (1 + β₀) m has 8u. |J_n| errs by 9u |v| and 10u |v_n|, as eq. (4); the direction g_t/|g_t| by 36u G/|g_t|.
/// Positions that are uncertain turn the axis, and g_t with it by 2G an angle.
template <typename Number>
Rough<Work<Number>> rough_of(const BodiesNow<Number>& b, const PairRules<Number>& rules,
                             const Vec<Work<Number>>& S, const Work<Number>& sigma, int dimension,
                             const Work<Number>& u) {
  using W = Work<Number>;
  using std::abs;
  const W K = inertia_ratio<W>(dimension);
  const W mass = K / (W(1) + K) * b.mu;
  const Vec<W> g = b.across() - cross(S, b.axis());
  const W speed = length(g);
  const W G = b.speed() + sigma;
  const W turn = b.turn_of_axis();
  const W v_n = abs(b.v_n());
  const W normal = (W(1) + W(rules.c_rebound)) * b.mu * v_n;
  const W holding = (W(1) + W(rules.beta0)) * mass * speed;
  const W most = W(rules.mu) * normal;
  const W of_g = W(18) * u * G + W(2) * turn * G + b.drift();
  const W of_holding = (W(1) + W(rules.beta0)) * mass * (of_g + W(8) * u * speed);
  const W of_most = W(rules.mu) * (W(1) + W(rules.c_rebound)) * b.mu *
                    (u * (W(9) * b.speed() + W(10) * v_n) + W(2) * turn * b.speed() + b.drift());
  Rough<W> rough{};
  rough.sticks = holding <= most;
  rough.boundary = abs(holding - most) <= of_holding + of_most;
  const W size = rough.sticks ? holding : most;
  const W turned = speed > W(0) ? size * std::min(W(2), W(W(2) * of_g / speed)) : W(0);
  rough.error = rough.sticks ? of_holding : of_most + turned;
  if (rough.boundary) rough.error = of_holding + of_most + turned;
  if (!(size > W(0))) return rough;
  rough.dp = W(size / speed) * g;
  rough.lost = size * (speed - size / (W(2) * mass));
  return rough;
}

/// The response by eq. (4), where it acts, with friction.
template <typename Number>
void add_friction(Response<Work<Number>>& response, const BodiesNow<Number>& b,
                  const Rough<Work<Number>>& rough) {
  using W = Work<Number>;
  if (length(response.dp) == W(0)) return;
  response.dp = response.dp + rough.dp;
  response.after = b.v - W(W(1) / b.mu) * response.dp;
  response.error += rough.error / W(kRoundingsOfImpulse);
  response.speed_error += rough.error / W(kRoundingsOfImpulse);
  response.lost = b.mu / W(2) * (dot(b.v, b.v) - dot(response.after, response.after));
}

}  // namespace tps::check
