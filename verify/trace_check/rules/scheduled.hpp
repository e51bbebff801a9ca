// Rules earliest and impulse, for impulses from outside and phase changes.
#pragma once

#include "verify/trace_check/rules/impulse.hpp"
#include "verify/trace_check/rules/known_events.hpp"

namespace tps::check {

/// What Δp of an impulse from outside has to be, and how far rounding may put it.
template <typename Number>
struct KickImpulse {
  Vec<Work<Number>> dp;
  Work<Number> error;
};

/// Scheduled and random impulses are those of the scene, rounded once; those of a shape below 1 have passed
/// through a power, which C libraries give to an ulp or so. The thermostat's is m (v' − v), v' drawn: a
/// subtraction and a product.
template <typename Number>
KickImpulse<Number> kick_impulse(const Context<Number>& c, Kind kind, const OutsideKick& kick) {
  using W = Work<Number>;
  const Model<Number>& model = c.model;
  const Particle& particle = model.scene.particles[Model<Number>::at(kick.particle)];
  const auto lifted = [&](const Coordinates& x) {
    Vec<W> result;
    for (std::size_t k = 0; k < 3; ++k) result[k] = W(stored<Number>(x[k], model.precision));
    return result;
  };
  if (kind == Kind::scheduled_impulse) return {lifted(model.kicks.scheduled().impulse), W(0)};
  if (kind == Kind::random_impulse) {
    const Vec<W> J = lifted(random_impulse(model.scene, particle, kick.number));
    const auto& law = model.scene.species[Model<Number>::at(particle.species)].random_impulses;
    constexpr double kUlpsOfPower = 4 * std::numeric_limits<double>::epsilon();
    return {J, law->shape < 1 ? W(kUlpsOfPower) * largest(J) : W(0)};
  }
  const Vec<W> v = lifted(maxwell_velocity(model.scene, particle, kick.number));
  const W inverse_mass = model.inverse_mass(kick.particle);
  const Vec<W> change = v - widened<W>(model.flight(kick.particle).velocity);
  const Vec<W> J = (W(1) / inverse_mass) * change;
  return {J, W(2) * c.u() * largest(J) + model.precision.smallest};
}

/// An impulse from outside is the scene's next of its kind: at its time, on its particle, with its Δp, and
/// acts by Δv = Δp/m of the body. By draws of another generator its time and size are taken as given.
template <typename Number>
void judge_kick(const Context<Number>& c, const EventLine<Number>& event) {
  using W = Work<Number>;
  const Model<Number>& model = c.model;
  const std::optional<OutsideKick> next = next_kick(c, event.kind);
  const bool by_scene = event.kind == Kind::scheduled_impulse || c.own_draws;
  std::optional<Vec<W>> dp;
  if (event.dp) dp = widened<W>(*event.dp);
  if (by_scene) {
    const bool there = next && next->particle == event.i;
    c.tally.demand(Rule::earliest, there, [&](Finding& f) {
      f.message = fmt::format("the scene has no {} on particle {} that is next", words(event.kind),
                              model.id(event.i));
    });
    if (!there) return;
    judge_scheduled_time(c, event, next->at, words(event.kind).c_str());
    const KickImpulse<Number> right = kick_impulse(c, event.kind, *next);
    if (dp) {
      c.tally.demand(Rule::impulse, largest(*dp - right.dp) <= right.error * c.scale(), [&](Finding& f) {
        f.message = fmt::format("the impulse is {}; the scene has {}", shown(*dp, model.scene.dimension),
                                shown(right.dp, model.scene.dimension));
      });
    } else {
      dp = right.dp;
    }
  } else {
    c.tally.not_judged(Rule::earliest, "times and sizes of random impulses are taken as given");
  }
  if (!dp) return;
  for (const InvolvedParticle<Number>& p : event.involved) {
    const Vec<W> before =
        widened<W>(p.velocity_before ? *p.velocity_before : model.flight(p.particle).velocity);
    judge_velocity_after(c, event, p.particle, before, *dp, W(0), model.inverse_mass(event.i),
                         model.loads(event.i));
  }
}

/// What gravity adds to velocities at its next event: g δ, at the first one half of it.
template <typename Number>
Vec<Work<Number>> gravity_change(const Context<Number>& c) {
  using W = Work<Number>;
  const Gravity& gravity = c.model.scene.gravity.value();
  const W every = W(stored<Number>(gravity.every, c.model.precision));
  Vec<W> change;
  for (std::size_t k = 0; k < 3; ++k)
    change[k] = W(stored<Number>(gravity.acceleration[k], c.model.precision)) * every;
  return c.model.kicks.gravity_done() == 0 ? W(0.5) * change : change;
}

/// Gravity acts at its times, with the scene's change of velocity rounded once.
template <typename Number>
void judge_gravity(const Context<Number>& c, const EventLine<Number>& event) {
  using W = Work<Number>;
  const std::optional<OutsideKick> next = next_kick(c, event.kind);
  c.tally.demand(Rule::earliest, next.has_value(),
                 [&](Finding& f) { f.message = "the scene has no gravity"; });
  if (!next) return;
  judge_scheduled_time(c, event, next->at, "gravity");
  if (!event.dv) return;
  const Vec<W> right = gravity_change(c);
  const Vec<W> found = widened<W>(*event.dv);
  const W error = c.u() * largest(right) + c.model.precision.smallest;
  c.tally.demand(Rule::impulse, largest(found - right) <= error * c.scale(), [&](Finding& f) {
    const auto [is, should] = told_apart(found, right, c.model.scene.dimension);
    f.message = fmt::format("gravity changes velocities by {}, but the scene has {}", is, should);
  });
}

/// The next change of the scene's phases, at its time.
template <typename Number>
void judge_phase(const Context<Number>& c, const EventLine<Number>& event) {
  const Model<Number>& model = c.model;
  const bool opens = event.kind == Kind::phase_begin;
  const bool there = model.phases_done < model.phase_changes.size() &&
                     model.phase_changes[model.phases_done].opens == opens &&
                     model.phase_changes[model.phases_done].phase == static_cast<std::size_t>(*event.phase);
  c.tally.demand(Rule::earliest, there, [&](Finding& f) {
    f.message = fmt::format("{} of phase {} is not the scene's next change of a phase", name(event.kind),
                            *event.phase);
  });
  if (there) judge_scheduled_time(c, event, model.phase_changes[model.phases_done].at, "phase change");
}

}  // namespace tps::check
