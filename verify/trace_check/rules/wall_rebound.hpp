// Rules contact, impulse and conservation, for the rebound of a particle from a wall.
#pragma once

#include "verify/trace_check/rules/conservation.hpp"
#include "verify/trace_check/rules/contact.hpp"
#include "verify/trace_check/rules/wall_flight.hpp"

namespace tps::check {

/// The particle and the wall as two bodies: along a plane's normal, wherever on it the particle is.
template <typename Number>
BodiesNow<Number> bodies_at_wall(const Context<Number>& c, const EventLine<Number>& event, std::size_t n) {
  using W = Work<Number>;
  const Model<Number>& model = c.model;
  const WallModel<Number>& wall = model.walls[n];
  const InvolvedParticle<Number>& p = *event.of(event.i);
  BodiesNow<Number> b;
  b.i = event.i;
  b.j = -1;
  b.v_i = widened<W>(p.velocity_before ? *p.velocity_before : model.flight(event.i).velocity);
  b.v_j = widened<W>(wall.velocity);
  b.drift_i = drift_before(model, event, event.i);
  b.v = b.v_j - b.v_i;
  b.inverse_i = model.inverse_mass(event.i);
  b.inverse_j = W(0);
  b.mu = W(1) / b.inverse_i;
  if (wall.is_plane()) {
    b.r = W(-1) * widened<W>(wall.normal);
    return b;
  }
  const Flight<Number> of_wall{wall.point, wall.velocity, {}, W(0)};
  const Vec<W> centre = widened<W>(carried(of_wall, event.t, model.precision, b.blur));
  if (!p.position_before)
    b.blur += model.blur_of_place(event.i, event.t) + c.time_error(event.t) * length(b.v);
  const Vec<W> place = p.position_before ? widened<W>(*p.position_before) : model.position(event.i, event.t);
  b.r = wall.measured(Vec<W>(centre - place));
  return b;
}

namespace detail {

/// Whether a particle is before the part of a box that it rebounds from. Which part that is hangs on the
/// exact touch, or where a graze turns, and the time that is recorded may be any other one within the error
/// of the timing: near a graze √(Q/a) away.
template <typename Number>
Within faces_at_event(const Context<Number>& c, const EventLine<Number>& event,
                      const WallFlight<Number>& flight, const Work<Number>& dt) {
  using W = Work<Number>;
  const W error = c.time_error(event.t);
  W from = dt - error, until = dt + error;
  const auto widen = [&](const W& earliest, const W& latest) {
    from = std::min(from, earliest);
    until = std::max(until, latest);
  };
  const Due<W> expected = due(flight);
  bool is_exact = false;
  if constexpr (std::is_same_v<Number, double>) {
    is_exact = c.certified();
    const CollisionTime<double> answer =
        is_exact ? c.exact.answer(timing_query(c, flight)) : CollisionTime<double>{};
    if (answer.t) widen(*answer.t, *answer.t);
  }
  if (!is_exact && !expected.must_be_none) widen(expected.earliest, expected.latest);
  if (!(until < std::numeric_limits<W>::infinity())) return Within::rounding;
  return in_region(c, c.model.walls[flight.n], flight.whole, std::max(W(0), from), until);
}

/// Whether a rebound comes when the particle is at the surface.
template <typename Number>
void judge_wall_contact(const Context<Number>& c, const EventLine<Number>& event,
                        const WallFlight<Number>& flight) {
  using W = Work<Number>;
  using std::abs;
  const W dt = elapsed(flight.pair.start, event.t);
  if (c.model.walls[flight.n].surface.region) {
    const Within here = faces_at_event(c, event, flight, dt);
    c.tally.demand(Rule::contact, here != Within::no, [&](Finding& f) {
      f.particles = {c.model.id(flight.i)};
      f.message = fmt::format("{} rebound where another part of the box is nearer", wall_name(c, flight));
    });
  }
  const auto describe = [&](Finding& f) {
    const Due<W> expected = due(flight);
    f.particles = {c.model.id(flight.i)};
    f.equation = "(2)";
    const bool early = dt < expected.earliest;
    const auto [found, bound] = told_apart(dt, early ? expected.earliest : expected.latest);
    f.message = fmt::format("{} rebound after {}; on straight lines they {}", wall_name(c, flight),
                            expected.must_be_none ? shown(dt) : found,
                            expected.must_be_none
                                ? "never touch"
                                : fmt::format("touch not {} than {}", early ? "earlier" : "later", bound));
  };
  if constexpr (std::is_same_v<Number, double>) {
    if (c.certified()) {
      c.tally.demand(
          Rule::contact,
          at_certified_time(c, event, flight.pair, flight.asked, c.exact.answer(timing_query(c, flight))),
          describe);
      return;
    }
  }
  const Due<W> expected = due(flight);
  const W slack = c.time_error(event.t);
  const bool in_time =
      !expected.must_be_none && dt >= expected.earliest - slack && dt <= expected.latest + slack;
  const W off = flight.is_plane
                    ? W(W(6) * abs(W(flight.gap - flight.towards * dt)) /
                        (flight.gap_error + flight.towards_error * dt + abs(flight.towards) * slack))
                    : W(W(6) * c.scale() * abs(flight.q.at(dt)) / flight.q.q_error);
  const bool is_there = off <= W(6) * c.scale();
  // A particle that rounding has left behind the surface is due at once, wherever exactly it is: how far
  // behind is a matter of the bounds.
  if (in_time)
    c.tally.within(Rule::contact, is_there ? as_double(off) : 0.0, 6, describe);
  else
    c.tally.demand(Rule::contact, false, describe);
}

/// What directed rounding may have moved the velocity by; an infinite mass keeps its own.
template <typename Number>
Work<Number> slack_at_wall(const Context<Number>& c, const EventLine<Number>& event,
                           const BodiesNow<Number>& b, bool outer, const Vec<Work<Number>>& dp,
                           const Work<Number>& error) {
  using W = Work<Number>;
  const W after = largest(widened<W>(event.of(b.i)->velocity_after));
  const W still = largest(b.v_j);
  const W stored = W(3) * c.u() * (after + still + b.inverse_i * largest(dp)) + b.inverse_i * error;
  const W reach = largest(c.model.position(b.i, event.t)) + length(b.r);
  const W of_axis = W(4) * c.u() * reach, roundings = W(54) * c.u();
  const W turn = (of_axis + b.blur) / b.distance();
  const W speeds = W(2) * (largest(b.v_i) + after + W(2) * still);
  return b.drift_i + directed_slack(c, b, outer, Vec<W>(b.v - b.inverse_i * dp), W(stored + b.drift_i),
                                    W(after + still), W((roundings + turn) * speeds + b.drift_i),
                                    moved_by_roundings(b, roundings, of_axis, speeds))
                         .of_i;
}

/// Why the event's wall and face are none of the scene's.
template <typename Number>
std::string no_such_surface(const std::vector<WallModel<Number>>& walls, const EventLine<Number>& event) {
  std::optional<int> last_face;
  bool is_there = false;
  for (const WallModel<Number>& wall : walls) {
    if (event.wall != static_cast<int>(wall.surface.wall)) continue;
    is_there = true;
    last_face = std::max(last_face, wall.surface.face);
  }
  const int last_wall = walls.empty() ? -1 : static_cast<int>(walls.back().surface.wall);
  if (!is_there) {
    return fmt::format("the scene has no wall {}; {}", event.wall.value_or(-1),
                       last_wall < 0 ? "it has none" : fmt::format("they are 0 to {}", last_wall));
  }
  if (!last_face) return fmt::format("wall {} is no box and has no faces; leave face out", *event.wall);
  return fmt::format("wall {} is a box, whose face the event has to name: from 0 to {}{}", *event.wall,
                     *last_face, event.face ? fmt::format(", not {}", *event.face) : "");
}

}  // namespace detail

/// The last rounding of the velocity is directed, so that the particle leaves the wall exactly (D25).
template <typename Number>
void judge_direction_at_wall(const Context<Number>& c, const EventLine<Number>& event, std::size_t n) {
  const WallModel<Number>& wall = c.model.walls[n];
  const InvolvedParticle<Number>& p = *event.of(event.i);
  const bool moves = !(wall.velocity == Vec<Number>{});
  // Where a moving centre is in a wider scalar is known to rounding only.
  if (c.minimal || !p.position_before || (moves && !wall.is_plane() && !std::is_same_v<Number, double>))
    return;
  Work<Number> no_blur(0);
  const Flight<Number> of_wall{wall.point, wall.velocity, {}, Work<Number>(0)};
  const Vec<Number> centre = carried(of_wall, event.t, c.model.precision, no_blur);
  const int sign =
      wall.is_plane()
          ? detail::exact_sign<Number>(wall.normal, Vec<Number>{}, p.velocity_after, wall.velocity)
          : detail::exact_sign<Number>(wall.measured(*p.position_before), wall.measured(centre),
                                       p.velocity_after, wall.velocity);
  const bool leaves = wall.is_inside() ? sign < 0 || p.velocity_after == wall.velocity : sign >= 0;
  c.tally.demand(Rule::impulse, leaves, [&](Finding& f) {
    f.message = fmt::format("particle {} leaves {} the wrong way by the last bits of its velocity (D22, D25)",
                            c.model.id(event.i), surface_name(wall.surface));
    f.equation = "(3)";
  });
}

/// Everything about the rebound of a particle from a wall.
template <typename Number>
void judge_wall_rebound(const Context<Number>& c, const EventLine<Number>& event) {
  using W = Work<Number>;
  const std::optional<std::size_t> n = c.model.wall_of(event);
  c.tally.demand(Rule::contact, n.has_value() && !c.model.fixed(event.i), [&](Finding& f) {
    f.message = n ? fmt::format("particle {} has infinite mass; no wall blocks it", c.model.id(event.i))
                  : detail::no_such_surface(c.model.walls, event);
  });
  if (!n || c.model.fixed(event.i)) return;
  const WallModel<Number>& wall = c.model.walls[*n];
  const bool outer = wall.is_inside();
  detail::judge_wall_contact(c, event, wall_flight(c, event.i, *n));
  const BodiesNow<Number> b = bodies_at_wall(c, event, *n);
  const Expected<W> expected{by_eq4(b, wall.c_rebound, outer, c.u()), kRoundingsOfImpulse, "(4)"};
  const W bound = W(expected.roundings) * expected.response.error;
  const auto about = [&](Finding& f) {
    f.particles = {c.model.id(event.i)};
    f.equation = "(4)";
  };
  if (event.dp) {
    const W off = largest(widened<W>(*event.dp) - expected.response.dp);
    c.tally.within(Rule::impulse, as_double(W(off / (expected.response.error + c.model.precision.smallest))),
                   expected.roundings, [&](Finding& f) {
                     about(f);
                     const auto [found, right] =
                         told_apart(widened<W>(*event.dp), expected.response.dp, c.model.scene.dimension);
                     f.message = fmt::format("Δp of particle {} at {} is {}, but eq. (4) gives {}",
                                             c.model.id(event.i), surface_name(wall.surface), found, right);
                   });
  }
  const Vec<W> dp = event.dp ? widened<W>(*event.dp) : expected.response.dp;
  const W error = event.dp ? W(0) : bound;
  const W slack = detail::slack_at_wall(c, event, b, outer, dp, error);
  judge_velocity_after(c, event, b.i, b.v_i, dp, W(error + slack / b.inverse_i), b.inverse_i, 0);
  judge_direction_at_wall(c, event, *n);
  Balance<W> balance{};
  balance.before_i = b.v_i;
  balance.before_j = balance.after_j = b.v_j;
  balance.after_i = widened<W>(event.of(b.i)->velocity_after);
  balance.inverse_i = b.inverse_i;
  balance.inverse_j = W(0);
  balance.exchanged = largest(dp);
  balance.directed.of_i = slack;
  balance.v_after = expected.response.after;
  balance.speed_error = bound;
  balance.taken = expected.response.lost;
  balance.energy_error = expected.response.lost_by_turning;
  detail::add_roundings(c, balance);
  const auto who = [&] {
    return fmt::format("particle {} and {}", c.model.id(event.i), surface_name(wall.surface));
  };
  judge_energy(c, balance, who);
  judge_angular_momentum(c, balance, b, who);
}

}  // namespace tps::check
