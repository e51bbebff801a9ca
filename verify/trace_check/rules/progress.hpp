// Rules progress and end: a run that stands still is called stalled; the last line says what happened.
#pragma once

#include "verify/trace_check/context.hpp"
#include "verify/trace_check/rules/known_events.hpp"

namespace tps::check {

/// More events in a row than this, while the clock rounded to the scalar stands still, are a stall
/// (docs/engine.md).
inline std::uint64_t stall_limit(std::size_t particles) {
  return 10000 + particles * (particles - 1) / 2;
}

/// A step may have several events, so that a stall is noticed up to a body's restitutions late.
template <typename Number>
void judge_progress(const Context<Number>& c, const EventLine<Number>&) {
  const Model<Number>& model = c.model;
  const std::uint64_t still = model.events - model.progress_event;
  const std::uint64_t limit = stall_limit(model.flights.size());
  c.tally.demand(Rule::progress, still <= limit + model.flights.size() + 1, [&](Finding& f) {
    f.message =
        fmt::format("the clock has stood still for {} events; a run of {} particles is stalled after {}",
                    still, model.flights.size(), limit);
  });
}

template <typename Number>
void judge_end(const Context<Number>& c, const EndLine<Number>& end) {
  using W = Work<Number>;
  using std::abs;
  const Model<Number>& model = c.model;
  c.tally.demand(Rule::end, end.events == model.events, [&](Finding& f) {
    f.message = fmt::format("the end counts {} events, the trace has {}", end.events, model.events);
  });
  const W apart = elapsed(model.now, end.t);
  const bool by_time = end.reason == "duration";
  const W error = c.minimal ? c.time_error(end.t) : W(0);
  c.tally.demand(Rule::end, by_time ? apart >= -error : abs(apart) <= error, [&](Finding& f) {
    f.message = fmt::format("the end is at {}, {} the last event at {}", c.shown_time(end.t),
                            by_time ? "before" : "and not at", c.shown_time(model.now));
  });
  const std::uint64_t still = model.events - model.progress_event;
  const bool stalls = still > stall_limit(model.flights.size());
  c.tally.demand(Rule::progress, stalls == (end.reason == "stalled"), [&](Finding& f) {
    f.message =
        fmt::format("the run ends as {}; the clock has stood still for {} events, a stall takes more than {}",
                    end.reason, still, stall_limit(model.flights.size()));
  });
}

}  // namespace tps::check
