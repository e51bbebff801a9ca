// Rule impulse: impulses and velocities after are those of eqs. (3)-(7).
#pragma once

#include "verify/trace_check/bodies_now.hpp"
#include "verify/trace_check/context.hpp"
#include "verify/trace_check/replay.hpp"
#include "verify/trace_check/rules/directed.hpp"

namespace tps::check {

/// What a collision should do: of a broken tether, what it would have done.
template <typename W>
struct Expected {
  Response<W> response;
  double roundings;      ///< of an evaluation, in units of response.error
  std::string equation;  ///< "(4)" or "(5)"
};

namespace detail {

/// Roundings of Δp by the formulas as they stand (docs/eq4.md, docs/eq5.md), four more for θ at its ends, and
/// two for each mass that was added up.
inline double roundings_of_impulse(int loads) {
  return 12 + 2 * loads;
}

template <typename Number>
void describe_impulse(const Context<Number>& c, const BodiesNow<Number>& b, const EventLine<Number>& event,
                      const Expected<Work<Number>>& expected, Finding& f) {
  const PairRules<Number>& rules = c.model.rules.of(b.i, b.j);
  const int dimension = c.model.scene.dimension;
  f.equation = expected.equation;
  const auto place = [&](int n) {
    const auto* p = event.of(n);
    return p->position_before ? widened<Work<Number>>(*p->position_before) : c.model.position(n, event.t);
  };
  ReplayInput in = replay_of_bodies(b, place(b.i), place(b.j), dimension);
  if (event.kind == Kind::rebound) {
    f.replay = Replay{"collision_impulse", in.number("c", rules.c_rebound).json()};
  } else {
    in.number("c_retract", rules.c_retract).number("c_revolve", rules.c_revolve);
    f.replay = Replay{"tether_response", in.number("theta_revolve_deg", rules.theta_deg).json()};
  }
}

}  // namespace detail

/// Whether the kind of a tethering collision is the one that the condition of the paper asks for; on the
/// boundary both are.
template <typename Number>
void judge_kind(const Context<Number>& c, const EventLine<Number>& event, const BodiesNow<Number>& b) {
  using W = Work<Number>;
  using std::abs;
  const PairRules<Number>& rules = c.model.rules.of(b.i, b.j);
  const W v_n = b.v_n();
  const W across = length(b.across());
  const W pulled = abs(W(rules.c_retract) * v_n);
  const W needed = rules.tan_theta * across;
  // Both sides have six roundings of |v|; positions add the turn of the axis, the tangent two more.
  const W turn = c.u() + b.blur / b.distance();
  const W unit = W(8) * turn * length(b.v) * (W(rules.c_retract) + rules.tan_theta) * c.scale() +
                 c.model.precision.smallest;
  const bool retracts = event.kind == Kind::retract;
  const bool boundary = abs(pulled - needed) <= unit || (v_n <= W(0) && !retracts);
  const bool right = boundary || (retracts ? pulled > needed : pulled < needed && across > W(0));
  c.tally.demand(Rule::impulse, right, [&](Finding& f) {
    f.message = fmt::format("{} {}s, but |c_retract v_n| = {} and tan θ |v_ŵ| = {}", c.pair(b.i, b.j),
                            name(event.kind), shown(pulled), shown(needed));
    detail::describe_impulse(c, b, event, Expected<W>{{}, 0, "(5)"}, f);
  });
}

/// The impulse that a collision calls for, by its kind.
template <typename Number>
Expected<Work<Number>> expected_of(const Context<Number>& c, const EventLine<Number>& event,
                                   const BodiesNow<Number>& b) {
  using W = Work<Number>;
  const PairRules<Number>& rules = c.model.rules.of(b.i, b.j);
  const double roundings = detail::roundings_of_impulse(b.loads);
  if (event.kind == Kind::rebound) return {by_eq4(b, rules.c_rebound, false, c.u()), roundings, "(4)"};
  const bool suffices = W(rules.c_retract) * b.v_n() > rules.tan_theta * length(b.across());
  const bool revolves = event.kind == Kind::revolve || (event.kind == Kind::broken && !suffices);
  if (revolves) return {by_eq5(b, rules, c.u()), roundings, "(5)"};
  return {by_eq4(b, rules.c_retract, true, c.u()), roundings, "(4)"};
}

/// Δp as recorded.
template <typename Number>
void judge_dp(const Context<Number>& c, const EventLine<Number>& event, const BodiesNow<Number>& b,
              const Expected<Work<Number>>& expected) {
  using W = Work<Number>;
  if (!event.dp) return;
  const W off = largest(widened<W>(*event.dp) - expected.response.dp);
  const W unit = expected.response.error + c.model.precision.smallest;
  c.tally.within(Rule::impulse, as_double(W(off / unit)), expected.roundings, [&](Finding& f) {
    f.message = fmt::format("Δp of {} is {}, but eq. {} gives {}", c.pair(b.i, b.j),
                            shown(*event.dp, c.model.scene.dimension), expected.equation,
                            shown(expected.response.dp, c.model.scene.dimension));
    detail::describe_impulse(c, b, event, expected, f);
  });
}

/// One unit of eq. (3): of v' and, for each rounding of the mass, of Δp/m; and what Δp itself may be off by.
template <typename Number>
Work<Number> velocity_unit(const Context<Number>& c, const Vec<Work<Number>>& after,
                           const Vec<Work<Number>>& impulse, const Work<Number>& impulse_error,
                           const Work<Number>& inverse_mass, int loads) {
  using W = Work<Number>;
  return c.u() * (largest(after) + W(1 + loads) * inverse_mass * largest(impulse)) +
         inverse_mass * impulse_error + c.model.precision.smallest;
}

/// What directed rounding may have changed of the velocities after an impulse by eq. (3), three units each.
template <typename Number>
DirectedChange<Work<Number>> directed_change(const Context<Number>& c, const BodiesNow<Number>& b, bool outer,
                                             const std::array<Work<Number>, 2>& inverse_masses,
                                             const Vec<Work<Number>>& dp, const Work<Number>& dp_error,
                                             int loads) {
  using W = Work<Number>;
  const Vec<W> after_i = b.v_i + inverse_masses[0] * dp;
  const Vec<W> after_j = b.v_j - inverse_masses[1] * dp;
  return directed_change(c, b, outer, inverse_masses, after_i, after_j,
                         W(3) * velocity_unit(c, after_i, dp, dp_error, inverse_masses[0], loads),
                         W(3) * velocity_unit(c, after_j, dp, dp_error, inverse_masses[1], loads));
}

/// Eq. (3), v + Δp/m, for every particle that an impulse moves: three roundings, and what directed rounding
/// may have changed.
template <typename Number>
void judge_velocity_after(const Context<Number>& c, const EventLine<Number>& event, int particle,
                          const Vec<Work<Number>>& before, const Vec<Work<Number>>& impulse,
                          const Work<Number>& impulse_error, const Work<Number>& inverse_mass, int loads,
                          const Work<Number>& directed = Work<Number>(0)) {
  using W = Work<Number>;
  using std::abs;
  const InvolvedParticle<Number>* p = event.of(particle);
  if (p == nullptr || c.model.fixed(particle)) return;
  const Vec<W> expected = before + inverse_mass * impulse;
  const Vec<W> after = widened<W>(p->velocity_after);
  const W unit = velocity_unit(c, after, impulse, impulse_error, inverse_mass, loads) + directed / W(3);
  c.tally.within(Rule::impulse, as_double(W(largest(after - expected) / unit)), 3, [&](Finding& f) {
    f.particles = {c.model.id(particle)};
    f.message = fmt::format("particle {} leaves with velocity {}, but v + Δp/m is {}", c.model.id(particle),
                            shown(p->velocity_after, c.model.scene.dimension),
                            shown(expected, c.model.scene.dimension));
    f.equation = "(3)";
    ReplayInput in(c.model.scene.dimension);
    in.number("m_A", mass_of(inverse_mass))
        .number("m_B", HUGE_VAL)
        .vector("v_A", before)
        .vector("v_B", Vec<W>{})
        .vector("dp", impulse);
    f.replay = Replay{"apply_impulse", in.json()};
  });
}

/// The velocities after a collision that is not grouped: by eq. (3) with the recorded Δp.
template <typename Number>
void judge_free_velocities(const Context<Number>& c, const EventLine<Number>& event,
                           const BodiesNow<Number>& b, const Expected<Work<Number>>& expected,
                           DirectedChange<Work<Number>>& directed) {
  using W = Work<Number>;
  const bool broken = event.kind == Kind::broken;
  const Vec<W> dp = broken ? Vec<W>{} : event.dp ? widened<W>(*event.dp) : expected.response.dp;
  const W error = broken || event.dp ? W(0) : W(expected.roundings) * expected.response.error;
  if (!broken) {
    directed =
        directed_change(c, b, event.kind != Kind::rebound, {b.inverse_i, b.inverse_j}, dp, error, b.loads);
  }
  judge_velocity_after(c, event, b.i, b.v_i, dp, error, b.inverse_i, b.loads, directed.i);
  judge_velocity_after(c, event, b.j, b.v_j, W(-1) * dp, error, b.inverse_j, b.loads, directed.j);
}

/// Eqs. (6) and (7): the common velocity, and the impulse that is kept.
template <typename Number>
void judge_load(const Context<Number>& c, const EventLine<Number>& event, const BodiesNow<Number>& b,
                const Expected<Work<Number>>& expected) {
  using W = Work<Number>;
  const Model<Number>& model = c.model;
  const int dimension = model.scene.dimension;
  // Weights m_A/(m_A + m_B) by inverse masses, which lets an infinite one through.
  const W sum = b.inverse_i + b.inverse_j;
  const Vec<W> v_load = W(b.inverse_j / sum) * b.v_i + W(b.inverse_i / sum) * b.v_j;
  const W unit = c.u() * (largest(b.v_i) + largest(b.v_j)) + model.precision.smallest;
  for (const InvolvedParticle<Number>& p : event.involved) {
    if (model.fixed(p.particle)) continue;
    const W off = largest(widened<W>(p.velocity_after) - v_load);
    c.tally.within(Rule::impulse, as_double(W(off / unit)), 6 + 2 * b.loads, [&](Finding& f) {
      f.particles = {model.id(p.particle)};
      f.message =
          fmt::format("particle {} is loaded with velocity {}, but v_load is {}", model.id(p.particle),
                      shown(p.velocity_after, dimension), shown(v_load, dimension));
      f.equation = "(6)";
      ReplayInput in(dimension);
      in.number("m_A", mass_of(b.inverse_i))
          .number("m_B", mass_of(b.inverse_j))
          .vector("v_A", b.v_i)
          .vector("v_B", b.v_j);
      f.replay = Replay{"load", in.json()};
    });
  }
  if (!event.dp_stored) return;
  const Vec<W> dp = event.dp ? widened<W>(*event.dp) : expected.response.dp;
  const Vec<W> kept = dp - b.mu * b.v;
  const W kept_unit = c.u() * (largest(dp) + b.mu * length(b.v)) +
                      (event.dp ? W(0) : expected.response.error) + model.precision.smallest;
  c.tally.within(Rule::impulse, as_double(W(largest(widened<W>(*event.dp_stored) - kept) / kept_unit)),
                 6 + 2 * b.loads, [&](Finding& f) {
                   f.message =
                       fmt::format("the impulse stored for {} is {}, but Δp − μ v_AB is {}", c.pair(b.i, b.j),
                                   shown(*event.dp_stored, dimension), shown(kept, dimension));
                   f.equation = "(7)";
                   ReplayInput in(dimension);
                   in.number("m_A", mass_of(b.inverse_i)).number("m_B", mass_of(b.inverse_j));
                   in.vector("v_A", b.v_i).vector("v_B", b.v_j).vector("dp", dp);
                   f.replay = Replay{"restitution_impulse", in.json()};
                 });
}

}  // namespace tps::check
