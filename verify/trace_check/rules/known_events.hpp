// Rule earliest, for what is known in advance: restitutions, and what effects have at given times.
#pragma once

#include "verify/trace_check/computed_time.hpp"
#include "verify/trace_check/context.hpp"
#include "verify/trace_check/rules/earliest.hpp"

namespace tps::check {

/// A time of the scene as the run has it.
template <typename Number>
Instant<Number> known_time(double t, const Precision<Number>& precision) {
  return {stored<Number>(t, precision), Number(0)};
}

/// The turn of something whose time is no answer to a query.
template <typename Number>
Turn<Number> known_turn(const Context<Number>& c, const Instant<Number>& t, int its_rank, int particle = -1) {
  Turn<Number> turn{t, std::nullopt, its_rank, particle, particle};
  if constexpr (std::is_same_v<Number, double>) {
    if (c.certified()) turn.moment = known_moment(t);
  }
  return turn;
}
template <typename Number>
Turn<Number> turn_of(const Context<Number>& c, const Body<Number>& body) {
  return known_turn(c, body.expiry, kRankOfRestitution, body.members.front());
}
template <typename Number>
Turn<Number> turn_of(const Context<Number>& c, const EffectRules<Number>& effect, const EventAhead& ahead) {
  return known_turn(c, known_time<Number>(ahead.at, c.model.precision), effect.rank());
}

/// Events of one effect that are missing at one place of a trace: more are no longer waited for, since a
/// scene can have any number of them between two events.
constexpr int kMostPassedOver = 1000;

/// What is known in advance and has been passed over by something. `is_due(turn, error)` decides, where the
/// times concerned may be off by `error`; what is found is not waited for any more. What happens is the next
/// event of `now` itself, null where it is no effect's; a body that parts is `parting`.
template <typename Number, typename IsDue>
void judge_waiting(const Context<Number>& c, const EffectRules<Number>* now, const Body<Number>* parting,
                   IsDue is_due) {
  using W = Work<Number>;
  Model<Number>& model = c.model;
  const bool narrow = std::is_same_v<Number, double>;
  while (const Body<Number>* body = model.groups.first_to_expire()) {
    const Turn<Number> turn = turn_of(c, *body);
    // Sums of the wider scalars are not the run's to the last bit.
    if (body == parting || !is_due(turn, narrow && !c.minimal ? W(0) : c.time_error(turn.t))) break;
    c.tally.demand(Rule::earliest, false, [&](Finding& f) {
      f.particles.clear();
      for (const int member : body->members) f.particles.push_back(model.id(member));
      f.message = fmt::format("the body of particle {} expires at {} and has not parted",
                              model.id(body->members.front()), c.shown_time(body->expiry));
      f.equation = "(7)";
    });
    model.groups.stop_waiting_for(body);
  }
  for (const auto& effect : model.effects) {
    if (effect.get() == now || effect->given_up) continue;
    int passed_over = 0;
    for (auto ahead = effect->next(c); ahead; ahead = effect->next(c)) {
      const Turn<Number> turn = turn_of(c, *effect, *ahead);
      if (!is_due(turn, c.minimal ? c.time_error(turn.t) : W(0))) break;
      c.tally.demand(Rule::earliest, false, [&](Finding& f) {
        f.message =
            fmt::format("the {} of time {} has not happened yet", effect->what(), c.shown_time(turn.t));
      });
      effect->pass(c);
      if (++passed_over < kMostPassedOver) continue;
      effect->given_up = true;
      c.tally.not_judged(Rule::earliest,
                         fmt::format("every {} after {}, of which {} in a row have not happened",
                                     effect->what(), c.shown_time(turn.t), kMostPassedOver));
      break;
    }
  }
}

/// Nothing that is known in advance is passed over by this event, which has its own turn.
template <typename Number>
void judge_known_events(const Context<Number>& c, const EventLine<Number>& event, const Turn<Number>& turn) {
  using W = Work<Number>;
  const bool parts = event.kind == Kind::restitute;
  judge_waiting<Number>(c, c.model.effect_of(event.kind),
                        parts ? c.model.groups.with_root(event.i, event.j) : nullptr,
                        [&](const Turn<Number>& other, const W& error) {
                          if (c.certified()) return c.turns.order(other, turn) < 0;
                          const W late = elapsed(other.t, event.t);
                          if (late > error) return true;
                          return !c.minimal && late == W(0) && c.turns.order(other, turn) < 0;
                        });
}

/// Nothing known in advance was left waiting at the duration of a run, or at all where it claims that no more
/// events are ahead. Within rounding of the end of a certified run exact order has a say: `left` is judged
/// together.
template <typename Number>
void judge_known_at_end(const Context<Number>& c, const Instant<Number>& end, Until until,
                        std::vector<LeftWaiting>& left) {
  using W = Work<Number>;
  judge_waiting<Number>(c, nullptr, nullptr, [&](const Turn<Number>& other, const W& error) {
    if (until == Until::ever) return true;
    if constexpr (std::is_same_v<Number, double>) {
      const Precision<double>& precision = c.model.precision;
      if (c.certified() && !(latest_rival(end, precision) < other.t) &&
          !(latest_rival(other.t, precision) < end)) {
        left.push_back({other, false, [&c, other](Finding& f) {
                          f.message = fmt::format("what the scene or a load has due at {} has not happened",
                                                  c.shown_time(other.t));
                        }});
        return false;
      }
    }
    return W(elapsed(other.t, end)) >= error;
  });
}

/// An event that the scene has at a given time is at that time; under certified timing at the clock's, where
/// that has passed it.
template <typename Number>
void judge_scheduled_time(const Context<Number>& c, const EventLine<Number>& event, double t,
                          const std::string& what) {
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
