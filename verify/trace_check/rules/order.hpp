// Rule order: events are counted from 1, time never goes back, dt is the difference of two times.
#pragma once

#include "verify/trace_check/context.hpp"

namespace tps::check {

/// Half the distance from dt to the next number; three quarters of it where a rounding may cost that
/// (docs/decisions.md, N18).
template <typename Number>
Work<Number> half_ulp(const Context<Number>& c, const Work<Number>& dt) {
  using std::frexp;
  using std::ldexp;
  using W = Work<Number>;
  int exponent = 0;
  static_cast<void>(frexp(dt, &exponent));
  return ldexp(W(c.u()), exponent - 1);
}

/// dt is rounded once. Where times differ by less than an ulp of them, the difference of their los has been
/// rounded before, by u² t.
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
  const W start = c.minimal ? W(abs(W(model.scene.start_time))) : W(0);
  const W times = abs(W(event.t.hi)) + abs(W(model.last_event.hi)) + W(2) * start;
  const W unit =
      half_ulp(c, dt) + model.precision.smallest + c.u() * (c.minimal ? W(1) : W(2) * c.u()) * times;
  constexpr double kOwnRounding =
      0x1p-8;  // of `apart`, where half an ulp is 2^-54 of it and a long double has 64 bits
  c.tally.within(Rule::order, as_double(W(abs(dt - apart) / unit)), 1 + kOwnRounding, [&](Finding& f) {
    f.message = fmt::format("dt is {}, but {} have passed since the event before", shown(dt), shown(apart));
  });
}

}  // namespace tps::check
