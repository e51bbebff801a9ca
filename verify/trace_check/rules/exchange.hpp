// What two bodies that part exchange, for rules impulse and conservation.
#pragma once

#include <algorithm>
#include <limits>

#include "verify/trace_check/bodies_now.hpp"
#include "verify/trace_check/context.hpp"
#include "verify/trace_check/responses.hpp"
#include "verify/trace_check/rules/directed.hpp"

namespace tps::check {

/// How much of v_n' roundings of the program are worth, its own axis included; ∞ where the places are not
/// known to the distance.
template <typename Number>
Work<Number> moved_by_roundings(const BodiesNow<Number>& b, const Work<Number>& roundings,
                                const Work<Number>& of_axis, const Work<Number>& speeds) {
  using W = Work<Number>;
  const W distance = b.distance() - b.blur;
  if (!(distance > W(0))) return std::numeric_limits<W>::infinity();
  return (roundings + of_axis / distance) * speeds + b.drift();
}

/// Of velocities by eq. (3) from Δp.
template <typename Number>
DirectedSlack<Work<Number>> slack_of_parting(const Context<Number>& c, const EventLine<Number>& event,
                                             const BodiesNow<Number>& b, bool outer,
                                             const Vec<Work<Number>>& dp, const Work<Number>& error,
                                             int loads) {
  using W = Work<Number>;
  const W inverse = b.inverse_i + b.inverse_j;
  const W after_i = largest(widened<W>(event.of(b.i)->velocity_after));
  const W after_j = largest(widened<W>(event.of(b.j)->velocity_after));
  const W stored =
      W(3) * c.u() * (after_i + after_j + W(3 + loads) / W(3) * inverse * largest(dp)) + inverse * error;
  // By how much rounding can turn v_n' (docs/engine.md): what is wrong by more was not rounding.
  const W of_axis = W(4) * c.u() * std::max(b.reach_i, b.reach_j);
  const W turn = (of_axis + b.blur) / b.distance();
  const W speeds = W(2) * (largest(b.v_i) + largest(b.v_j) + after_i + after_j + b.speeds_at_load);
  const W roundings = W(54 + 4 * loads) * c.u();
  DirectedSlack<W> slack = directed_slack(c, b, outer, b.v - inverse * dp, W(stored + b.drift()),
                                          W(after_i + after_j), W((roundings + turn) * speeds + b.drift()),
                                          moved_by_roundings(b, roundings, of_axis, speeds));
  slack.of_i += b.drift_i;
  slack.of_j += b.drift_j;
  return slack;
}

/// What two bodies that part exchange, and how far it and directed rounding may be off.
template <typename W>
struct Exchange {
  Vec<W> dp;
  W error;
  DirectedSlack<W> slack;
};

template <typename Number>
Exchange<Work<Number>> exchange_of(const Context<Number>& c, const EventLine<Number>& event,
                                   const BodiesNow<Number>& b, bool outer, const Vec<Work<Number>>& dp,
                                   const Work<Number>& error) {
  return {dp, error, slack_of_parting(c, event, b, outer, dp, error, b.loads)};
}
/// At a collision that is not grouped: Δp as recorded or, where it is not, as it should be.
template <typename Number>
Exchange<Work<Number>> exchange_of(const Context<Number>& c, const EventLine<Number>& event,
                                   const BodiesNow<Number>& b, const Expected<Work<Number>>& expected) {
  using W = Work<Number>;
  const Vec<W> dp = event.dp ? widened<W>(*event.dp) : expected.response.dp;
  const W error = event.dp ? W(0) : W(expected.roundings) * expected.response.error;
  return exchange_of(c, event, b, event.kind != Kind::rebound, dp, error);
}

}  // namespace tps::check
