// What eqs. (4) and (5) make of a collision, and how far an evaluation in the trace's scalar may be from it
// (docs/check.md, "Bounds").
#pragma once

#include <algorithm>
#include <string_view>

#include "reference/equations/square_root.hpp"
#include "verify/trace_check/bodies_now.hpp"

namespace tps::check {

/// Roundings of Δp by the formulas as they stand (docs/eq4.md, docs/eq5.md).
constexpr double kRoundingsOfImpulse = 12;

template <typename W>
struct Response {
  Vec<W> dp;
  Vec<W> after;          ///< v_AB'
  W error;               ///< of dp, one unit of kRoundingsOfImpulse; a component may be off by as much
  W speed_error;         ///< of |v_AB'|, in the same units: what turns v_AB' does not change its length
  W lost;                ///< energy
  W lost_by_turning{0};  ///< what the energy may be off by, as the axis is not known better
};

namespace detail {

/// Some unit vector perpendicular to a unit vector, in the plane where that is: for a pair without motion
/// across its axis, which rounding turns anywhere, but does not make faster.
template <typename W>
Vec<W> any_across(const Vec<W>& axis) {
  const W in_plane = square_root(W(axis[0] * axis[0] + axis[1] * axis[1]));
  if (!(in_plane > W(0))) return {{W(1), W(0), W(0)}};
  return {{W(-axis[1] / in_plane), W(axis[0] / in_plane), W(0)}};
}

}  // namespace detail

/// Eq. (4): Δp = (1 + c) μ v_n û; nothing where the sign of v_n is the wrong one.
///
/// v_n is a sum of products of the size of |v|, so that 8 of its roundings are of that size, whatever it is
/// itself: of r, v_AB, û and the sum. What then multiplies it has 13, of the size of v_n: û again with its
/// length, μ, 1 + c and the products. The masses of bodies were added up rounded: that is an error of μ.
template <typename Number>
Response<Work<Number>> by_eq4(const BodiesNow<Number>& b, const Number& c_stored, bool outer,
                              const Work<Number>& u) {
  using W = Work<Number>;
  using std::abs;
  const W c(c_stored);
  const W v_n = b.v_n();
  const W across = b.speed_across();
  const bool acts = outer ? v_n > W(0) : v_n < W(0);
  const W speed = b.speed();
  const W turn = b.turn_of_axis();
  const W rounding = (W(1) + c) * b.mu * (u * (W(8) * speed + W(13 + 2 * b.loads) * abs(v_n)) + b.drift()) /
                     W(kRoundingsOfImpulse);
  // û and v_n û turn with the axis; by a right angle and more everything is possible.
  const W turned = (W(1) + c) * b.mu * std::min(W(W(2) * speed * turn), W(W(2) * speed));
  Response<W> response{{}, b.v, rounding + turned / W(kRoundingsOfImpulse), rounding, W(0)};
  const W wider = std::min(W(abs(v_n) + across * turn), speed) + b.drift();
  response.lost_by_turning = b.mu / W(2) * (W(1) - c * c) * std::max(W(0), W(wider * wider - v_n * v_n));
  if (!acts) return response;
  response.dp = W((W(1) + c) * b.mu * v_n) * b.axis();
  response.after = b.v - W((W(1) + c) * v_n) * b.axis();
  response.lost = b.mu / W(2) * (W(1) - c * c) * v_n * v_n;
  return response;
}

/// Eq. (5): Δp = μ (v − v'), v' = c^(θ/π) |v| (cos θ ŵ − sin θ û).
///
/// ŵ is the direction of a difference: it turns by u |v|/|v_ŵ|, in the end anywhere, and v' with its part
/// cos θ ŵ. û_revolve is a unit vector wherever it points, so that |v'| is known to a few roundings; a power
/// of a small c_revolve has the error of its exponent, ln c times.
template <typename Number>
Response<Work<Number>> by_eq5(const BodiesNow<Number>& b, const PairRules<Number>& rules,
                              const Work<Number>& u) {
  using W = Work<Number>;
  const Vec<W> w = b.across();
  const W across = length(w);
  const W speed = b.speed();
  const W cosine = W(1) / square_root(W(1) + rules.tan_theta * rules.tan_theta);
  const W sine = rules.tan_theta * cosine;
  const W after = rules.speed_ratio * speed;
  const W sensitivity = W(1) + rules.exponent_of_ratio / W(4);
  const W of_drift = b.drift() * (W(1) + rules.speed_ratio) / W(kRoundingsOfImpulse);
  const W length_error =
      b.mu * (u * (speed + after * sensitivity + W(b.loads) * (speed + after) / W(6)) + of_drift);
  const W anywhere = W(2) * after * cosine;
  const W turn = b.turn_of_axis();
  const Vec<W> w_hat = across > W(0) ? W(W(1) / across) * w : detail::any_across(b.axis());
  const Vec<W> v_after = W(after * cosine) * w_hat - W(after * sine) * b.axis();
  W turned = anywhere;
  if (across > W(0)) {
    const W of_w = (W(kRoundingsOfImpulse) * u * speed + W(2) * turn * speed + W(2) * b.drift()) / across;
    turned = std::min(anywhere, W(after * cosine * of_w));
  }
  turned = turned + std::min(W(W(2) * turn), W(2)) * after * sine;
  return Response<W>{b.mu * (b.v - v_after), v_after, length_error + b.mu * turned / W(kRoundingsOfImpulse),
                     length_error, b.mu / W(2) * (speed * speed - after * after)};
}

/// Eq. (6): the common velocity of two bodies.
template <typename W>
struct Loaded {
  Vec<W> velocity;
  W error;  ///< all of it
};

constexpr double kRoundingsOfLoad = 6;

/// Each velocity has its weight, m_A/(m_A + m_B), and so has its rounding: beside a heavy body that stands
/// still a light one, however fast, costs little. Masses that were added up rounded shift the weights.
template <typename Number>
Loaded<Work<Number>> by_eq6(const BodiesNow<Number>& b, const Work<Number>& u) {
  using W = Work<Number>;
  // By inverse masses, which lets an infinite one through.
  const W sum = b.inverse_i + b.inverse_j;
  const W weight_i = b.inverse_j / sum;
  const W weight_j = b.inverse_i / sum;
  const W rounding = W(kRoundingsOfLoad) * (weight_i * largest(b.v_i) + weight_j * largest(b.v_j));
  return {weight_i * b.v_i + weight_j * b.v_j,
          u * (rounding + W(b.loads) * weight_i * weight_j * largest(b.v)) + weight_i * b.drift_i +
              weight_j * b.drift_j};
}

/// What a collision should do: of a broken tether, what it would have done.
template <typename W>
struct Expected {
  Response<W> response;
  double roundings;           ///< of an evaluation, in units of response.error
  std::string_view equation;  ///< "(4)" or "(5)"
};

}  // namespace tps::check
