// Rule impulse: impulses and velocities after are those of eqs. (3)-(7).
#pragma once

#include "verify/trace_check/bodies_now.hpp"
#include "verify/trace_check/context.hpp"
#include "verify/trace_check/responses.hpp"
#include "verify/trace_check/rough.hpp"
#include "verify/trace_check/rules/direction.hpp"
#include "verify/trace_check/rules/exchange.hpp"
#include "verify/trace_check/rules/readings.hpp"
#include "verify/trace_check/step_as_case.hpp"

namespace tps::check {

namespace detail {

template <typename Number>
void describe_impulse(const Context<Number>& c, const BodiesNow<Number>& b, const EventLine<Number>& event,
                      const Expected<Work<Number>>& expected, Finding& f) {
  const PairRules<Number>& rules = c.model.rules.of(b.i, b.j);
  const int dimension = c.model.scene.dimension;
  f.equation = expected.equation;
  if (event.kind == Kind::rebound && rules.rubs) return;  // no operation has spins
  const auto place = [&](int n) {
    const auto* p = event.of(n);
    return p->position_before ? widened<Work<Number>>(*p->position_before) : c.model.position(n, event.t);
  };
  ReplayInput in = replay_of_bodies(b, place(b.i), place(b.j), dimension);
  if (event.kind == Kind::rebound) {
    f.replay = Replay{operations::Op::collision_impulse, in.number("c", rules.c_rebound).json()};
  } else {
    in.number("c_retract", rules.c_retract).number("c_revolve", rules.c_revolve);
    f.replay =
        Replay{operations::Op::tether_response, in.number("theta_revolve_deg", rules.theta_deg).json()};
  }
}

}  // namespace detail

/// How far c_retract v_n and tan θ |v_ŵ| may be computed from each other: both sides have six roundings of
/// |v|, the tangent two more; positions add the turn of the axis.
template <typename Number>
Work<Number> margin_of_kind(const BodiesNow<Number>& b, const PairRules<Number>& rules,
                            const Work<Number>& u) {
  using W = Work<Number>;
  return ((W(8) * u + W(2) * b.turn_of_axis()) * b.speed() + b.drift()) *
         (W(rules.c_retract) + rules.tan_theta);
}

/// Whether the kind of a tethering collision is the one that the condition of the paper asks for; on the
/// boundary both are.
template <typename Number>
void judge_kind(const Context<Number>& c, const EventLine<Number>& event, const BodiesNow<Number>& b) {
  using W = Work<Number>;
  using std::abs;
  const PairRules<Number>& rules = c.model.rules.of(b.i, b.j);
  const W v_n = b.v_n();
  const W across = b.speed_across();
  const W pulled = abs(W(rules.c_retract) * v_n);
  const W needed = rules.tan_theta * across;
  const W unit = margin_of_kind(b, rules, c.u()) * c.scale() + c.model.precision.smallest;
  const bool retracts = event.kind == Kind::retract;
  const bool boundary = abs(pulled - needed) <= unit || (v_n <= W(0) && !retracts);
  const bool right = boundary || (retracts ? pulled > needed : pulled < needed && across > W(0));
  c.tally.demand(Rule::impulse, right, [&](Finding& f) {
    const auto [has, needs] = told_apart(pulled, needed);
    f.message = fmt::format("{} {}s, but |c_retract v_n| = {} and tan θ |v_ŵ| = {}", c.pair(b.i, b.j),
                            name(event.kind), has, needs);
    detail::describe_impulse(c, b, event, Expected<W>{{}, 0, "(5)"}, f);
  });
}

/// What friction does at a rebound, by the spins before it.
template <typename Number>
Rough<Work<Number>> rough_now(const Context<Number>& c, const BodiesNow<Number>& b) {
  using W = Work<Number>;
  const auto surface = [&](int n) {
    return W(c.model.radius(n)) * widened<W>(c.model.spins[Model<Number>::at(n)]);
  };
  const Vec<W> of_i = surface(b.i), of_j = surface(b.j);
  return rough_of(b, c.model.rules.of(b.i, b.j), of_i + of_j, W(length(of_i) + length(of_j)),
                  c.model.scene.dimension, c.u());
}

/// The impulse that a collision calls for, by its kind.
template <typename Number>
Expected<Work<Number>> expected_of(const Context<Number>& c, const EventLine<Number>& event,
                                   const BodiesNow<Number>& b) {
  using W = Work<Number>;
  const PairRules<Number>& rules = c.model.rules.of(b.i, b.j);
  constexpr double roundings = kRoundingsOfImpulse;
  if (event.kind == Kind::rebound && rules.rubs) {
    Expected<W> expected{by_eq4(b, rules.c_rebound, false, c.u()), roundings, "(4) with friction"};
    add_friction(expected.response, b, rough_now(c, b));
    return expected;
  }
  if (event.kind == Kind::rebound) return {by_eq4(b, rules.c_rebound, false, c.u()), roundings, "(4)"};
  const bool suffices = W(rules.c_retract) * b.v_n() > rules.tan_theta * b.speed_across();
  const bool revolves = event.kind == Kind::revolve || (event.kind == Kind::broken && !suffices);
  if (revolves) return {by_eq5(b, rules, c.u()), roundings, "(5)"};
  return {by_eq4(b, rules.c_retract, true, c.u()), roundings, "(4)"};
}

/// Positions may be so uncertain that any Δp would do; then there is nothing to judge.
template <typename Number>
bool is_vague(const Context<Number>& c, const BodiesNow<Number>& b, const Expected<Work<Number>>& expected) {
  using W = Work<Number>;
  if (b.blur == W(0) && b.drift() == W(0)) return false;
  const W bound = W(expected.roundings) * expected.response.error;
  if (bound < length(expected.response.dp)) return false;
  c.tally.cannot_tell(Rule::impulse, [&] {
    return fmt::format("where the axis of {} is uncertain by {} radians and Δp by {}", c.pair(b.i, b.j),
                       shown(b.turn_of_axis()), shown(bound));
  });
  return true;
}

/// Δp as recorded.
template <typename Number>
void judge_dp(const Context<Number>& c, const EventLine<Number>& event, const BodiesNow<Number>& b,
              const Expected<Work<Number>>& expected) {
  using W = Work<Number>;
  if (!event.dp || is_vague(c, b, expected)) return;
  const W off = largest(widened<W>(*event.dp) - expected.response.dp);
  const W unit = expected.response.error + c.model.precision.smallest;
  c.tally.within(Rule::impulse, as_double(W(off / unit)), expected.roundings, [&](Finding& f) {
    const Vec<W> dp = widened<W>(*event.dp);
    const auto [found, right] = told_apart(dp, expected.response.dp, c.model.scene.dimension);
    f.message =
        fmt::format("Δp of {} is {}, but eq. {} gives {}", c.pair(b.i, b.j), found, expected.equation, right);
    f.reading = reading_of_impulse(c, event, b, expected, dp, W(0));
    detail::describe_impulse(c, b, event, expected, f);
  });
}

/// Eq. (3), v + Δp/m, for every particle that an impulse moves: two roundings of Δp/m, however it is written,
/// and one of the sum; `impulse_error` is what Δp may be off by.
template <typename Number>
void judge_velocity_after(const Context<Number>& c, const EventLine<Number>& event, int particle,
                          const Vec<Work<Number>>& before, const Vec<Work<Number>>& impulse,
                          const Work<Number>& impulse_error, const Work<Number>& inverse_mass, int loads,
                          const std::string& reading = {}) {
  using W = Work<Number>;
  using std::abs;
  const InvolvedParticle<Number>* p = event.of(particle);
  if (p == nullptr || c.model.fixed(particle)) return;
  const Vec<W> expected = before + inverse_mass * impulse;
  const Vec<W> after = widened<W>(p->velocity_after);
  const W unit = c.u() * (largest(after) + W(3 + loads) / W(3) * inverse_mass * largest(impulse)) +
                 inverse_mass * impulse_error / W(3) + c.model.precision.smallest;
  c.tally.within(Rule::impulse, as_double(W(largest(after - expected) / unit)), 3, [&](Finding& f) {
    f.particles = {c.model.id(particle)};
    const auto [found, right] = told_apart(after, expected, c.model.scene.dimension);
    f.message = fmt::format("particle {} leaves with velocity {}, but v + Δp/m is {}", c.model.id(particle),
                            found, right);
    f.equation = "(3)";
    f.reading = reading;
    ReplayInput in(c.model.scene.dimension);
    in.number("m_A", mass_of(inverse_mass))
        .number("m_B", HUGE_VAL)
        .vector("v_A", before)
        .vector("v_B", Vec<W>{})
        .vector("dp", impulse);
    f.replay = Replay{operations::Op::apply_impulse, in.json()};
  });
}

/// v + Δp/m on both sides, each to its rounding and that of a direction.
template <typename Number>
void judge_parted(const Context<Number>& c, const EventLine<Number>& event, const BodiesNow<Number>& b,
                  const Exchange<Work<Number>>& exchange, const std::string& reading = {}) {
  using W = Work<Number>;
  const auto moved = [](const W& by, const W& inverse) { return inverse > W(0) ? W(by / inverse) : W(0); };
  judge_velocity_after(c, event, b.i, b.v_i, exchange.dp,
                       W(exchange.error + moved(exchange.slack.of_i, b.inverse_i)), b.inverse_i, b.loads,
                       reading);
  judge_velocity_after(c, event, b.j, b.v_j, W(-1) * exchange.dp,
                       W(exchange.error + moved(exchange.slack.of_j, b.inverse_j)), b.inverse_j, b.loads,
                       reading);
}

/// Without an impulse nothing is computed: velocities stay, to the last bit.
template <typename Number>
void judge_unchanged(const Context<Number>& c, const EventLine<Number>& event) {
  const int dimension = c.model.scene.dimension;
  for (const InvolvedParticle<Number>& p : event.involved) {
    const Vec<Number>& before = p.velocity_before ? *p.velocity_before : c.model.flight(p.particle).velocity;
    const bool stays = is_same_velocity(p.velocity_after, before, drift_before(c.model, event, p.particle));
    c.tally.demand(Rule::impulse, stays, [&](Finding& f) {
      const auto [found, right] = told_apart(p.velocity_after, before, dimension);
      f.particles = {c.model.id(p.particle)};
      f.message =
          fmt::format("particle {} leaves with velocity {}, but a {} gives no impulse and it came with {}",
                      c.model.id(p.particle), found, name(event.kind), right);
      f.equation = "(3)";
    });
  }
}

/// The velocities after a collision that is not grouped: by eq. (3) with the recorded Δp.
template <typename Number>
void judge_free_velocities(const Context<Number>& c, const EventLine<Number>& event,
                           const BodiesNow<Number>& b, const Expected<Work<Number>>& expected,
                           const Exchange<Work<Number>>& exchange) {
  if (!event.dp && is_vague(c, b, expected)) return;
  judge_parted(c, event, b, exchange, event.dp ? "" : reading_of_velocities(c, event, b, expected));
}

/// Eqs. (6) and (7): the common velocity, and the impulse that is kept.
template <typename Number>
void judge_load(const Context<Number>& c, const EventLine<Number>& event, const BodiesNow<Number>& b,
                const Expected<Work<Number>>& expected) {
  using W = Work<Number>;
  const Model<Number>& model = c.model;
  const int dimension = model.scene.dimension;
  const Loaded<W> loaded = by_eq6(b, c.u());
  const Vec<W>& v_load = loaded.velocity;
  const W unit = loaded.error / W(kRoundingsOfLoad) + model.precision.smallest;
  for (const InvolvedParticle<Number>& p : event.involved) {
    if (model.fixed(p.particle)) continue;
    const W off = largest(widened<W>(p.velocity_after) - v_load);
    c.tally.within(Rule::impulse, as_double(W(off / unit)), kRoundingsOfLoad, [&](Finding& f) {
      f.particles = {model.id(p.particle)};
      const auto [found, right] = told_apart(widened<W>(p.velocity_after), v_load, dimension);
      f.message = fmt::format("particle {} is loaded with velocity {}, but v_load is {}",
                              model.id(p.particle), found, right);
      f.equation = "(6)";
      ReplayInput in(dimension);
      in.number("m_A", mass_of(b.inverse_i))
          .number("m_B", mass_of(b.inverse_j))
          .vector("v_A", b.v_i)
          .vector("v_B", b.v_j);
      f.replay = Replay{operations::Op::load, in.json()};
    });
  }
  if (!event.dp_stored) return;
  const Vec<W> dp = event.dp ? widened<W>(*event.dp) : expected.response.dp;
  const Vec<W> kept = dp - b.mu * b.v;
  const W kept_unit = c.u() * (largest(dp) + W(6 + b.loads) / W(6) * b.mu * b.speed()) +
                      (event.dp ? W(0) : W(expected.roundings / 6) * expected.response.error) +
                      b.mu * b.drift() / W(6) + model.precision.smallest;
  c.tally.within(Rule::impulse, as_double(W(largest(widened<W>(*event.dp_stored) - kept) / kept_unit)), 6,
                 [&](Finding& f) {
                   const auto [found, right] = told_apart(widened<W>(*event.dp_stored), kept, dimension);
                   f.message = fmt::format("the impulse stored for {} is {}, but Δp − μ v_AB is {}",
                                           c.pair(b.i, b.j), found, right);
                   f.equation = "(7)";
                   ReplayInput in(dimension);
                   in.number("m_A", mass_of(b.inverse_i)).number("m_B", mass_of(b.inverse_j));
                   in.vector("v_A", b.v_i).vector("v_B", b.v_j).vector("dp", dp);
                   f.replay = Replay{operations::Op::restitution_impulse, in.json()};
                 });
}

}  // namespace tps::check
