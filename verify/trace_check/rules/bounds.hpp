// Rule bounds: over its whole flight no pair comes closer than its inner limit, or goes beyond its outer one.
#pragma once

#include "reference/equations/square_root.hpp"
#include "verify/trace_check/rules/limit_flight.hpp"

namespace tps::check {
namespace detail {

/// How far beyond the limit the pair came during its flight, as squared distance, less what it began with.
template <typename W>
W excess_of(const Quadratic<W>& q, bool outer, const W& dt) {
  const W zero(0);
  if (outer) return std::max(q.at(dt), q.c) - std::max(zero, q.c);
  const W turning = q.a > zero ? W(-q.h / q.a) : zero;
  const W closest = std::min(std::max(zero, turning), dt);
  return std::min(zero, q.c) - std::min(q.at(closest), q.c);
}

/// Whether the pair creeps: it has responded at this limit, and what it moves towards it by is no more than
/// rounding of its response (docs/check.md, bounds).
template <typename Number>
bool creeps(const Context<Number>& c, const LimitFlight<Number>& flight) {
  using W = Work<Number>;
  const bool outer = flight.asked.outer;
  if (!c.model.responded(flight.i, flight.j, outer)) return false;
  constexpr int kRoundings = 24;
  const W rounding =
      W(kRoundings) * c.u() * c.model.speeds_before_response(flight.i, flight.j, outer) * length(flight.q.r);
  return (outer ? flight.q.h : W(-flight.q.h)) <= rounding;
}

/// Judges how far the pair came beyond its limit. Of a pair that has responded the relative velocity is known
/// to rounding only, and of a minimal trace, when the flight ended.
template <typename Number>
bool judge_bounds(const Context<Number>& c, const LimitFlight<Number>& flight, bool is_asked,
                  const Work<Number>& time_error) {
  using W = Work<Number>;
  using std::abs;
  const PairFlight<Number>& pair = flight.pair;
  const LimitAsked<W>& asked = flight.asked;
  const Quadratic<W>& q = flight.q;
  const bool may_creep = !is_asked || asked.responded;
  const W speeds = length(widened<W>(pair.v_i)) + length(widened<W>(pair.v_j));
  const W unit = farthest_beyond(q, c.u(), c.scale(), flight.dt) / (W(6) * c.scale()) +
                 (may_creep ? W(4) * asked.L * c.u() * speeds * flight.dt : W(0)) +
                 asked.L * time_error * length(q.v) / W(3);
  const W excess = excess_of(q, asked.outer, flight.dt);
  if (!(excess > W(6) * unit * c.scale())) return true;
  const W beyond = asked.outer ? W(square_root(asked.L * asked.L + excess) - asked.L)
                               : W(asked.L - square_root(std::max(W(0), W(asked.L * asked.L - excess))));
  return c.tally.within(Rule::bounds, as_double(W(excess / unit)), 6, [&](Finding& f) {
    say_about(c, flight, f);
    f.equation = "(1)";
    f.message = fmt::format("{} comes {} beyond its {} limit {} in flight", c.pair(flight.i, flight.j),
                            shown(beyond), flight.limit(), shown(asked.L));
    if (creeps(c, flight)) {
      f.message = fmt::format(
          "creep: {}; since it responded it {} by v_n = {}, which is rounding; round velocities after a "
          "response so that it does not",
          f.message, asked.outer ? "separates" : "approaches", shown(W(q.h / length(q.r))));
    }
  });
}

}  // namespace detail

}  // namespace tps::check
