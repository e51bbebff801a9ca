// Rule order: events are counted from 1, come in their turns, and dt is the difference of two times.
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
  c.tally.demand(Rule::order, !(event.t < model.now), [&](Finding& f) {
    f.message = fmt::format("time goes back from {} to {}", c.shown_time(model.now), c.shown_time(event.t));
  });
  if (!event.dt) return;
  const W apart = elapsed(model.now, event.t);
  const W dt(*event.dt);
  // A minimal trace rounds its times, too.
  const W start = c.minimal ? model.start_of_clock() : W(0);
  const W times = abs(W(event.t.hi)) + abs(W(model.now.hi)) + W(2) * start;
  const W unit =
      half_ulp(c, dt) + model.precision.smallest + c.u() * (c.minimal ? W(1) : W(2) * c.u()) * times;
  constexpr double kOwnRounding =
      0x1p-8;  // of `apart`, where half an ulp is 2^-54 of it and a long double has 64 bits
  c.tally.within(Rule::order, as_double(W(abs(dt - apart) / unit)), 1 + kOwnRounding, [&](Finding& f) {
    f.message = fmt::format("dt is {}, but {} have passed since the event before", shown(dt), shown(apart));
  });
}

/// What was waiting while other things happened had its turn after them: it began to wait at the step
/// `since`.
template <typename Number>
void judge_turn(const Context<Number>& c, const EventLine<Number>& event, const Turn<Number>& turn,
                StepNumber since) {
  // Times of a minimal trace are rounded, so that equal ones are no tie.
  if (c.minimal) return;
  const Turn<Number>* const latest = c.turns.latest_since(since, turn);
  if (latest == nullptr && !c.turns.is_of_before(since)) return;
  c.tally.demand(Rule::order, latest == nullptr || c.turns.order(turn, *latest) >= 0, [&](Finding& f) {
    const auto name_of = [&](int i) {
      return i < 0 ? std::string("the scene's") : std::to_string(c.model.id(i));
    };
    const bool tie = c.turns.order_in_time(turn, *latest) == 0;
    f.message = fmt::format("{} comes behind an event of {} at {} that {}", name(event.kind),
                            latest->second == latest->first
                                ? name_of(latest->first)
                                : fmt::format("{}-{}", name_of(latest->first), name_of(latest->second)),
                            c.shown_time(latest->t),
                            tie ? "was due at exactly the same time and comes after it by rank and ids"
                                : "is exactly later, though both were waiting");
  });
}

}  // namespace tps::check
