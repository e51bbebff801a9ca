// Rule earliest, for what is known in advance: restitutions, phase changes and scheduled impulses.
#pragma once

#include "verify/trace_check/context.hpp"
#include "verify/trace_check/rules/earliest.hpp"

namespace tps::check {

/// Order at one time (docs/decisions.md, D13).
constexpr int rank(Kind kind) {
  if (kind == Kind::restitute) return 0;
  if (is_phase(kind)) return 1;
  return kind == Kind::scheduled_impulse ? 2 : 3;
}

/// A time of the scene as the run has it.
template <typename Number>
Instant<Number> known_time(double t, const Precision<Number>& precision) {
  return {stored<Number>(t, precision), Number(0)};
}

/// When a body expires: its latest load and Δt_restitute, hi + lo.
template <typename Number>
Instant<Number> expiry_of(const Model<Number>& model, const Body<Number>& body) {
  const Number dt = stored<Number>(model.scene.grouping->dt_restitute, model.precision);
  if constexpr (std::is_same_v<Number, double>) {
    const exact::DoubleWord sum = exact::two_sum(body.loaded.hi, dt);
    const exact::DoubleWord normal = exact::two_sum(sum.hi, sum.lo + body.loaded.lo);
    return {normal.hi, normal.lo};
  } else {
    return {body.loaded.hi + dt, Number(0)};
  }
}

namespace detail {

/// Whether something known in advance should have come before the event that happens.
template <typename Number>
bool is_late(const Context<Number>& c, const Instant<Number>& due_at, int its_rank,
             const Happening<Number>& happening, int rank_now, const Work<Number>& error) {
  using W = Work<Number>;
  const W late = elapsed(due_at, happening.t);
  if constexpr (std::is_same_v<Number, double>) {
    if (c.certified() && happening.moment && std::fabs(late) > error) {
      const std::weak_ordering order =
          c.exact.order(Moment{due_at.hi, due_at.lo, std::nullopt, 1}, *happening.moment);
      return order < 0 || (order == 0 && its_rank < rank_now);
    }
  }
  if (late > error) return true;
  return late == W(0) && its_rank < rank_now;
}

}  // namespace detail

/// Nothing that is known in advance is passed over by this event.
template <typename Number>
void judge_known_events(const Context<Number>& c, const EventLine<Number>& event,
                        const Happening<Number>& happening) {
  using W = Work<Number>;
  Model<Number>& model = c.model;
  const int now = rank(event.kind);
  // Scheduled times are stored numbers; the times of a minimal trace are rounded.
  const W stored_error = c.minimal ? c.time_error(event.t) : W(0);
  if (model.scene.grouping) {
    while (const Body<Number>* body = model.groups.first_to_expire()) {
      const Instant<Number> expiry = expiry_of(model, *body);
      if (!detail::is_late(c, expiry, rank(Kind::restitute), happening, now, c.time_error(event.t))) break;
      if (event.kind == Kind::restitute) break;  // its own rule says whether it is in time
      c.tally.demand(Rule::earliest, false, [&](Finding& f) {
        f.particles.clear();
        for (const int member : body->members) f.particles.push_back(model.id(member));
        f.message = fmt::format("the body of particle {} expires at {} and has not parted",
                                model.id(body->members.front()), c.shown_time(expiry));
        f.equation = "(7)";
      });
      model.groups.stop_waiting_for(body);
    }
  }
  const auto scheduled = [&](double t, Kind kind, const char* what) {
    const Instant<Number> due_at = known_time<Number>(t, model.precision);
    if (!detail::is_late(c, due_at, rank(kind), happening, now, stored_error)) return false;
    c.tally.demand(Rule::earliest, false, [&](Finding& f) {
      f.message = fmt::format("the {} of time {} has not happened yet", what, c.shown_time(due_at));
    });
    return true;
  };
  while (!is_phase(event.kind) && model.phases_done < model.phase_changes.size() &&
         scheduled(model.phase_changes[model.phases_done].at, Kind::phase_begin, "phase change")) {
    model.apply_phase_change();
  }
  while (event.kind != Kind::scheduled_impulse && model.impulses_done < model.impulses.size() &&
         scheduled(model.impulses[model.impulses_done].at, Kind::scheduled_impulse, "scheduled impulse")) {
    ++model.impulses_done;
  }
}

/// An event that the scene has at a given time is at that time; under certified timing at the clock's, where
/// that has passed it.
template <typename Number>
void judge_scheduled_time(const Context<Number>& c, const EventLine<Number>& event, double t,
                          const char* what) {
  using W = Work<Number>;
  using std::abs;
  const W late = elapsed(known_time<Number>(t, c.model.precision), event.t);
  const bool clock_had_passed =
      c.certified() && event.t == c.model.now && late > W(0) && late <= W(2.5) * c.u() * abs(W(event.t.hi));
  const W error = c.minimal ? c.time_error(event.t) : W(0);
  c.tally.demand(Rule::earliest, abs(late) <= error || clock_had_passed, [&](Finding& f) {
    f.message = fmt::format("the {} is due at {} and happens {} {}", what,
                            c.shown_time(known_time<Number>(t, c.model.precision)), shown(W(abs(late))),
                            late > W(0) ? "later" : "earlier");
  });
}

}  // namespace tps::check
