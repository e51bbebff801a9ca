// Rule conservation: momentum, energy and angular momentum balance at every event.
#pragma once

#include "reference/equations/square_root.hpp"
#include "verify/trace_check/bodies_now.hpp"
#include "verify/trace_check/context.hpp"
#include "verify/trace_check/rules/impulse.hpp"

namespace tps::check {

/// Two bodies before and after a step, what they exchanged and what the step took from them. Errors are whole
/// bounds.
template <typename W>
struct Balance {
  Vec<W> before_i, before_j, after_i, after_j;  ///< velocities
  W inverse_i, inverse_j;
  int loads = 0;        ///< masses that were added up rounded
  W exchanged;          ///< size of the impulse
  W momentum_error{0};  ///< beyond the rounding of the velocities: of a common velocity
  DirectedSlack<W> directed{};
  W rounding_i{0}, rounding_j{0};  ///< momentum_rounding of either
  Vec<W> v_after;                  ///< v_AB' as it should be
  W speed_error;                   ///< of |v_AB'| times μ
  W taken;                         ///< energy, for good or stored
  W energy_error{0};               ///< beyond those
};

namespace detail {

/// How far a stored velocity may be from v + Δp/m, times the mass: three roundings, see
/// judge_velocity_after.
template <typename Number>
Work<Number> momentum_rounding(const Context<Number>& c, bool of_i, const Balance<Work<Number>>& x) {
  using W = Work<Number>;
  const W& inverse_mass = of_i ? x.inverse_i : x.inverse_j;
  if (inverse_mass == W(0)) return W(0);
  const W after = largest(of_i ? x.after_i : x.after_j);
  return W(3) * (c.u() * (after / inverse_mass + W(3 + x.loads) / W(3) * x.exchanged) +
                 c.model.precision.smallest * (W(1) + W(1) / inverse_mass)) +
         (of_i ? x.directed.of_i : x.directed.of_j) / inverse_mass;
}

/// REQUIRES all that the rounding is of.
template <typename Number>
void add_roundings(const Context<Number>& c, Balance<Work<Number>>& x) {
  x.rounding_i = momentum_rounding(c, true, x);
  x.rounding_j = momentum_rounding(c, false, x);
}

}  // namespace detail

/// What both bodies gain is nothing, but for the rounding of their velocities: Δp is the same number for
/// both. `who()` names them, here and below.
template <typename Number, typename Who>
void judge_momentum(const Context<Number>& c, const Balance<Work<Number>>& x, const Who& who) {
  using W = Work<Number>;
  if (x.inverse_i == W(0) || x.inverse_j == W(0)) return;  // it takes any
  const Vec<W> drift =
      W(W(1) / x.inverse_i) * (x.after_i - x.before_i) + W(W(1) / x.inverse_j) * (x.after_j - x.before_j);
  const W bound = x.rounding_i + x.rounding_j + x.momentum_error;
  const W unit = bound / W(3);
  c.tally.residual(Quantity::momentum, as_double(x.exchanged),
                   as_double(W((drift[0] + drift[1] + drift[2]) / unit)));
  c.tally.within(Rule::conservation, as_double(W(largest(drift) / unit)), 3, [&](Finding& f) {
    f.message = fmt::format("{} gain the momentum {} together", who(), shown(drift, c.model.scene.dimension));
    f.equation = "(3)";
  });
}

/// The energy of the relative motion, ½ μ |v_AB|²: that of the common motion is the momentum's matter, and a
/// wall does no work in its own frame.
template <typename Number, typename Who>
void judge_energy(const Context<Number>& c, const Balance<Work<Number>>& x, const Who& who) {
  using std::abs;
  using W = Work<Number>;
  const W inverse = x.inverse_i + x.inverse_j;
  const W mu = W(1) / inverse;
  const Vec<W> v_after = x.after_j - x.after_i;
  const Vec<W> v_before = x.before_j - x.before_i;
  const W off = mu / W(2) * dot(W(1) * (v_after - x.v_after), v_after + x.v_after);
  const W stored = x.rounding_i * x.inverse_i + x.rounding_j * x.inverse_j;
  const W speed_error = square_root(W(c.model.scene.dimension)) * (stored + inverse * x.speed_error);
  const W bound = mu * (length(x.v_after) * speed_error + speed_error * speed_error / W(2)) + x.energy_error +
                  c.model.precision.smallest;
  const W unit = bound / W(3);
  c.tally.residual(Quantity::energy, as_double(x.exchanged), as_double(W(off / unit)));
  c.tally.within(Rule::conservation, as_double(W(abs(off) / unit)), 3, [&](Finding& f) {
    const W gained = mu / W(2) * (dot(v_after, v_after) - dot(v_before, v_before));
    const auto [found, expected] = told_apart(gained, W(-x.taken));
    f.message =
        fmt::format("the energy of {} changes by {}; the coefficients make that {}", who(), found, expected);
    f.equation = "(4)";
  });
}

/// An impulse along the line of the two turns nothing. Each of the four roundings of its components turns it.
template <typename Number, typename Who>
void judge_angular_momentum(const Context<Number>& c, const Balance<Work<Number>>& x,
                            const BodiesNow<Number>& b, const Who& who) {
  using W = Work<Number>;
  const bool of_i = x.inverse_j == W(0) || (x.inverse_i != W(0) && x.rounding_i < x.rounding_j);
  const Vec<W> gained = of_i ? W(W(1) / x.inverse_i) * (x.after_i - x.before_i)
                             : W(W(1) / x.inverse_j) * (x.after_j - x.before_j);
  const W& stored = of_i ? x.rounding_i : x.rounding_j;
  const W bound =
      b.distance() * (square_root(W(c.model.scene.dimension)) * stored + W(4) * c.u() * length(gained) +
                      std::min(W(1), b.turn_of_axis()) * length(gained)) +
      c.model.precision.smallest;
  const Vec<W> torque = cross(b.r, gained);
  c.tally.within(Rule::conservation, as_double(W(W(3) * length(torque) / bound)), 3, [&](Finding& f) {
    f.message = fmt::format("{} gain the angular momentum {}: the impulse is not along the line of the two",
                            who(), shown(torque, 3));
    f.equation = "(4)";
  });
}

/// The two bodies of an event, before and after it; what they exchanged is the caller's.
template <typename Number>
Balance<Work<Number>> balance_of(const EventLine<Number>& event, const BodiesNow<Number>& b) {
  using W = Work<Number>;
  Balance<W> balance{};
  balance.before_i = b.v_i;
  balance.before_j = b.v_j;
  balance.after_i = widened<W>(event.of(b.i)->velocity_after);
  balance.after_j = widened<W>(event.of(b.j)->velocity_after);
  balance.inverse_i = b.inverse_i;
  balance.inverse_j = b.inverse_j;
  balance.loads = b.loads;
  return balance;
}

/// A collision that is not grouped.
template <typename Number>
void judge_conservation(const Context<Number>& c, const EventLine<Number>& event, const BodiesNow<Number>& b,
                        const Expected<Work<Number>>& expected, const Exchange<Work<Number>>& exchange) {
  using W = Work<Number>;
  const Response<W>& response = expected.response;
  Balance<W> balance = balance_of(event, b);
  balance.exchanged = largest(exchange.dp);
  balance.directed = exchange.slack;
  detail::add_roundings(c, balance);
  balance.v_after = response.after;
  balance.speed_error = W(expected.roundings) * response.speed_error;
  balance.taken = response.lost;
  balance.energy_error = response.lost_by_turning;
  const auto who = [&] { return c.pair(b.i, b.j); };
  judge_momentum(c, balance, who);
  judge_energy(c, balance, who);
  if (expected.equation == "(4)") judge_angular_momentum(c, balance, b, who);
}

/// A load takes ½ μ |v_AB|² out of the motion, whatever of it is stored or lost.
template <typename Number>
void judge_load_conservation(const Context<Number>& c, const EventLine<Number>& event,
                             const BodiesNow<Number>& b) {
  using W = Work<Number>;
  const W joined =
      b.inverse_i == W(0) || b.inverse_j == W(0) ? W(0) : W(1) / b.inverse_i + W(1) / b.inverse_j;
  Balance<W> balance = balance_of(event, b);
  balance.exchanged = b.mu * largest(b.v);
  balance.momentum_error = joined * by_eq6(b, c.u()).error;
  detail::add_roundings(c, balance);
  balance.taken = b.mu / W(2) * dot(b.v, b.v);
  const auto who = [&] { return c.pair(b.i, b.j); };
  judge_momentum(c, balance, who);
  judge_energy(c, balance, who);
}

/// The parting of two bodies gives back what their load stored: v_AB' of its collision, whose size may be
/// known where its direction is not.
template <typename Number>
void judge_parting_conservation(const Context<Number>& c, const EventLine<Number>& event,
                                const BodiesNow<Number>& b, const LoadNode<Number>& node,
                                const Exchange<Work<Number>>& exchange) {
  using W = Work<Number>;
  const Vec<W>& dp = exchange.dp;
  const W inverse = b.inverse_i + b.inverse_j;
  Balance<W> balance = balance_of(event, b);
  balance.exchanged = largest(dp);
  balance.directed = exchange.slack;
  detail::add_roundings(c, balance);
  balance.v_after = (b.v_j - b.v_i) - inverse * dp;
  balance.speed_error = node.speed_error;
  balance.energy_error = node.energy_error;
  balance.taken = W(-dot(dp, dp) * inverse / W(2));
  const auto who = [&] { return c.pair(b.i, b.j); };
  judge_momentum(c, balance, who);
  judge_energy(c, balance, who);
}

}  // namespace tps::check
