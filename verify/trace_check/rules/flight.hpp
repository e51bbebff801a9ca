// Rule flight: between events a particle flies straight, u + v dt.
#pragma once

#include "verify/trace_check/context.hpp"

namespace tps::check {

/// The recorded position has two roundings, of v dt and of the sum, and dt has one: 2 u |v dt| + u |u'|, and
/// half as much again for scalars that subtract to 0.75 ulp.
template <typename Number>
void judge_flight(const Context<Number>& c, const EventLine<Number>& event) {
  using W = Work<Number>;
  using std::abs;
  const Model<Number>& model = c.model;
  for (const InvolvedParticle<Number>& p : event.involved) {
    const std::optional<Vec<Number>>& recorded = p.position_before ? p.position_before : p.position_after;
    if (!recorded) continue;
    const Flight<Number>& flight = model.flight(p.particle);
    const W dt = elapsed(flight.since, event.t);
    const W blur = model.blur(p.particle), time_error = c.time_error(event.t);
    W worst(0), off(0);
    std::size_t axis = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const W step = W(flight.velocity[k]) * dt;
      const W expected = W(flight.position[k]) + step;
      const W unit = c.u() * (W(2) * abs(step) + abs(W((*recorded)[k]))) + model.precision.smallest + blur +
                     time_error * abs(W(flight.velocity[k]));
      const W ulps = abs(W((*recorded)[k]) - expected) / unit;
      if (ulps > worst) {
        worst = ulps;
        axis = k;
        off = W((*recorded)[k]) - expected;
      }
    }
    c.tally.within(Rule::flight, as_double(worst), 1.5, [&](Finding& f) {
      f.particles = {model.id(p.particle)};
      f.message =
          fmt::format("particle {} is {} off the straight line along axis {}, after flying for {} from {}",
                      model.id(p.particle), shown(off), "xyz"[axis], shown(dt), c.shown_time(flight.since));
      f.equation = "(1)";
    });
  }
}

}  // namespace tps::check
