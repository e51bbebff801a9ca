// Rules earliest and impulse, for an impulse from outside on one particle, whatever effect it is of.
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

/// A vector of the scene as the run has it.
template <typename Number>
Vec<Work<Number>> stored_vector(const Context<Number>& c, const Coordinates& x) {
  Vec<Work<Number>> result;
  for (std::size_t k = 0; k < 3; ++k) result[k] = Work<Number>(stored<Number>(x[k], c.model.precision));
  return result;
}

/// Whether the event is the next one of its effect, on its particle; then at its time, too.
template <typename Number>
bool judge_is_next(const Context<Number>& c, const EventLine<Number>& event,
                   const std::optional<EventAhead>& next) {
  const bool there = next && next->particle == event.i;
  c.tally.demand(Rule::earliest, there, [&](Finding& f) {
    f.message = fmt::format("the scene has no {} on particle {} that is next", words(event.kind),
                            c.model.id(event.i));
  });
  if (there) judge_scheduled_time(c, event, next->at, words(event.kind));
  return there;
}

/// It acts by Δv = Δp/m of the body.
template <typename Number>
void judge_pushed(const Context<Number>& c, const EventLine<Number>& event, const Vec<Work<Number>>& dp) {
  using W = Work<Number>;
  const Model<Number>& model = c.model;
  for (const InvolvedParticle<Number>& p : event.involved) {
    const Vec<W> before =
        widened<W>(p.velocity_before ? *p.velocity_before : model.flight(p.particle).velocity);
    const W inverse = model.inverse_mass(event.i);
    const W drift = drift_before(model, event, p.particle);
    judge_velocity_after(c, event, p.particle, before, dp, inverse > W(0) ? W(drift / inverse) : W(0),
                         inverse, model.loads(event.i));
  }
}

/// An impulse from outside is the next of its effect, with the Δp that `right_impulse()` says.
template <typename Number, typename RightImpulse>
void judge_kick(const Context<Number>& c, const EventLine<Number>& event,
                const std::optional<EventAhead>& next, RightImpulse right_impulse) {
  using W = Work<Number>;
  if (!judge_is_next(c, event, next)) return;
  const KickImpulse<Number> right = right_impulse();
  if (!event.dp) return judge_pushed(c, event, right.dp);
  const Vec<W> dp = widened<W>(*event.dp);
  c.tally.demand(Rule::impulse, largest(dp - right.dp) <= right.error * c.scale(), [&](Finding& f) {
    f.message = fmt::format("the impulse is {}; the scene has {}", shown(dp, c.model.scene.dimension),
                            shown(right.dp, c.model.scene.dimension));
  });
  judge_pushed(c, event, dp);
}

}  // namespace tps::check
