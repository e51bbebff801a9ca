// Rules earliest and impulse, for scheduled impulses and phase changes.
#pragma once

#include "verify/trace_check/rules/impulse.hpp"
#include "verify/trace_check/rules/known_events.hpp"

namespace tps::check {

/// J of the scene on its particle, Δv = J/m of the body.
template <typename Number>
void judge_scheduled_impulse(const Context<Number>& c, const EventLine<Number>& event) {
  using W = Work<Number>;
  const Model<Number>& model = c.model;
  const bool there =
      model.impulses_done < model.impulses.size() && model.impulses[model.impulses_done].particle == event.i;
  c.tally.demand(Rule::earliest, there, [&](Finding& f) {
    f.message = fmt::format("the scene has no impulse on particle {} that is next", model.id(event.i));
  });
  if (!there) return;
  const ScheduledImpulse& next = model.impulses[model.impulses_done];
  judge_scheduled_time(c, event, next.at, "scheduled impulse");
  Vec<W> J;
  for (std::size_t k = 0; k < 3; ++k) J[k] = W(stored<Number>(next.impulse[k], model.precision));
  if (event.dp) {
    c.tally.demand(Rule::impulse, widened<W>(*event.dp) == J, [&](Finding& f) {
      f.message = fmt::format("the impulse is {}; the scene has {}", shown(*event.dp, model.scene.dimension),
                              shown(J, model.scene.dimension));
    });
  }
  for (const InvolvedParticle<Number>& p : event.involved) {
    const Vec<W> before =
        widened<W>(p.velocity_before ? *p.velocity_before : model.flight(p.particle).velocity);
    judge_velocity_after(c, event, p.particle, before, J, W(0), model.inverse_mass(event.i),
                         model.loads(event.i));
  }
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
