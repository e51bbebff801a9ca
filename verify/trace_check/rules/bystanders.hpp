// Rule bystanders: what is not involved does not change; neither does what cannot.
#pragma once

#include "verify/trace_check/bodies_now.hpp"
#include "verify/trace_check/context.hpp"

namespace tps::check {

/// Velocities between events and positions at them are copies: no rounding is allowed.
template <typename Number>
void judge_bystanders(const Context<Number>& c, const EventLine<Number>& event) {
  const Model<Number>& model = c.model;
  const int dimension = model.scene.dimension;
  for (const InvolvedParticle<Number>& p : event.involved) {
    const std::int32_t id = model.id(p.particle);
    const Flight<Number>& flight = model.flight(p.particle);
    const auto about = [&](Finding& f) { f.particles = {id}; };
    if (p.velocity_before) {
      const bool kept = is_same_velocity(*p.velocity_before, flight.velocity, flight.drift);
      c.tally.demand(Rule::bystanders, kept, [&](Finding& f) {
        about(f);
        const auto [found, right] = told_apart(*p.velocity_before, flight.velocity, dimension);
        f.message = fmt::format("particle {} comes with velocity {}, but left its last event with {}", id,
                                found, right);
      });
    }
    if (p.position_before && p.position_after) {
      c.tally.demand(Rule::bystanders, *p.position_before == *p.position_after, [&](Finding& f) {
        about(f);
        const auto [from, to] = told_apart(*p.position_before, *p.position_after, dimension);
        f.message = fmt::format(
            "particle {} is moved by the event from {} to {}; impulses change velocities only", id, from, to);
      });
    }
    if (model.fixed(p.particle)) {
      c.tally.demand(Rule::bystanders, p.velocity_after == flight.velocity, [&](Finding& f) {
        about(f);
        const auto [found, right] = told_apart(p.velocity_after, flight.velocity, dimension);
        f.message = fmt::format("particle {} has infinite mass and changes its velocity from {} to {}", id,
                                right, found);
      });
    }
  }
}

}  // namespace tps::check
