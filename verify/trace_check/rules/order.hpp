// Rule order: events are counted from 1, time never goes back, dt is the difference of two times.
#pragma once

#include "verify/trace_check/context.hpp"

namespace tps::check {

/// dt is rounded once: half an ulp, 1 u of it; 1.5 u where subtraction rounds to 0.75 ulp (docs/decisions.md,
/// N18).
template <typename Number>
void judge_order(const Context<Number>& c, const EventLine<Number>& event) {
  using W = Work<Number>;
  using std::abs;
  const Model<Number>& model = c.model;
  const std::uint64_t expected = model.events + 1;
  if (event.k) {
    c.tally.demand(Rule::order, *event.k == expected, [&](Finding& f) {
      f.message =
          fmt::format("is event {}, after event {}; events are counted one by one", *event.k, model.events);
    });
  }
  c.tally.demand(Rule::order, !(event.t < model.last_event), [&](Finding& f) {
    f.message =
        fmt::format("time goes back from {} to {}", c.shown_time(model.last_event), c.shown_time(event.t));
  });
  if (!event.dt) return;
  const W apart = elapsed(model.last_event, event.t);
  const W dt(*event.dt);
  // A minimal trace rounds its times, too.
  const W unit = c.u() * abs(dt) + model.precision.smallest +
                 (c.minimal ? c.u() * (abs(W(event.t.hi)) + abs(W(model.last_event.hi))) : W(0));
  c.tally.within(Rule::order, as_double(W(abs(dt - apart) / unit)), 1.5, [&](Finding& f) {
    f.message = fmt::format("dt is {}, but {} have passed since the event before", shown(dt), shown(apart));
  });
}

}  // namespace tps::check
