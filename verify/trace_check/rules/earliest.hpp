// Rule earliest: what a pair that is not at its event must not have done meanwhile.
#pragma once

#include <span>

#include "reference/equations/square_root.hpp"
#include "reference/version.hpp"
#include "verify/trace_check/computed_time.hpp"
#include "verify/trace_check/context.hpp"
#include "verify/trace_check/rules/bounds.hpp"
#include "verify/trace_check/rules/direction.hpp"
#include "verify/trace_check/rules/images_on_the_way.hpp"
#include "verify/trace_check/rules/readings.hpp"

namespace tps::check {

/// Until when a pair is judged.
enum class Until {
  event,       ///< that is happening
  last_event,  ///< of a run that ended there
  duration,    ///< of a run that reached it
  ever,        ///< after a run that claims that nothing more happens
};

/// A pair or body that a certified run left waiting and whose computed time is not clearly behind the end.
struct LeftWaiting {
  Turn<double> turn;
  bool outer = false;
  std::function<void(Finding&)> describe;
};

/// What a pair is asked about: everything that happened while it flew.
template <typename Number>
struct Happening {
  Instant<Number> t;
  int i = -1, j = -1;               ///< of a collision, which is no longer waiting itself
  std::optional<std::size_t> wall;  ///< which i meets
  bool outer = false;
  Until until = Until::event;
  std::vector<LeftWaiting>* left = nullptr;  ///< filled at the duration of a certified run

  bool is(int a, int b, bool at_outer) const { return a == i && b == j && outer == at_outer; }
};

/// What is left open or wrong of a pair at one of its limits.
enum class Waiting { not_due, undecided, overdue, lost_a_tie };

namespace detail {

/// The turn of a certified pair that flies on; nothing where it has no event at that limit.
inline std::optional<Turn<double>> certified_turn(const Context<double>& c, const PairFlight<double>& pair,
                                                  int i, int j, const LimitAsked<long double>& asked,
                                                  const std::optional<CertifiedTime>& certified) {
  if (!certified || !certified->answer.t) return std::nullopt;
  const CollisionTime<double>& answer = certified->answer;
  // Since responses are rounded directedly, a pulled pair that separates was rounded since, and is due at
  // once.
  const bool counts = answer.verdict == TimingVerdict::hit || answer.verdict == TimingVerdict::turning ||
                      (asked.outer && c.semantics >= kDirectedSemantics);
  if (asked.responded && !counts) return std::nullopt;
  const int multiple = asked.responded && answer.verdict == TimingVerdict::turning ? 2 : 1;
  const double dt = multiple * rounded_once(c.exact, certified->query, *answer.t, c.model.precision);
  Turn<double> turn;
  turn.t = later_by(pair.start, dt, c.model.precision);
  turn.moment =
      exact::KnownMoment{{pair.start.hi, pair.start.lo, certified->query, multiple}, certified->known};
  turn.first = i;
  turn.second = j;
  return turn;
}

/// Exact: whether something that waits since the step `since` had its turn before the latest of what happened
/// meanwhile.
template <typename Number>
Waiting waiting_behind(const Context<Number>& c, const Turn<Number>& turn, StepNumber since) {
  const Turn<Number>* const latest = c.turns.latest_since(since, turn);
  if (latest == nullptr || c.turns.order(turn, *latest) >= 0) return Waiting::not_due;
  return c.turns.order_in_time(turn, *latest) == 0 ? Waiting::lost_a_tie : Waiting::overdue;
}

/// Beyond every time that the trace's timing can have computed; undecided where real arithmetic has an event
/// that its rounding need not see.
template <typename Number>
Waiting computed_waiting(const Context<Number>& c, const Quadratic<Work<Number>>& q,
                         const LimitAsked<Work<Number>>& asked, const Work<Number>& dt,
                         const Work<Number>& slack) {
  using W = Work<Number>;
  const Due<W> expected = due(q, asked);
  if (!expected.can_be_none)
    return expected.latest + slack * c.scale() < dt ? Waiting::overdue : Waiting::not_due;
  if (asked.outer || q.h >= W(0)) return Waiting::not_due;
  const W D = q.discriminant();
  const W exactly = q.c <= W(0) ? W(0) : D > W(0) ? W(q.c / (square_root(D) - q.h)) : W(dt + W(1));
  return exactly + slack < dt ? Waiting::undecided : Waiting::not_due;
}

/// Sees to it that a certified run has left nothing waiting that was due by its end.
inline Waiting certified_waiting(const Context<double>& c, const Turn<double>& turn, bool outer,
                                 StepNumber since, const Happening<double>& happening,
                                 const std::function<void(Finding&)>& describe) {
  const Waiting state = waiting_behind(c, turn, since);
  if (state != Waiting::not_due) return state;
  if (happening.until == Until::ever)
    return is_a_time(turn.t, c.model.precision) ? Waiting::overdue : Waiting::not_due;
  if (happening.until == Until::duration && !(latest_rival(happening.t, c.model.precision) < turn.t))
    happening.left->push_back({turn, outer, describe});
  return Waiting::not_due;
}

}  // namespace detail

/// What came of asking a pair.
struct Asked {
  bool earliest = true;  ///< nothing was violated or left open
  bool bounds = true;
};

/// What has been said already of a pair's present flight, one bit a limit and kind of finding, so that it is
/// said once.
struct Told {
  enum Bit : unsigned { overdue = 1, undecided = 2, beyond = 4, of_outer = 8 };
  unsigned bits = 0;

  bool said(unsigned bit, bool outer) const { return (bits & (outer ? bit * of_outer : bit)) != 0; }
  /// Whether it is new.
  bool say(unsigned bit, bool outer) {
    const unsigned mask = outer ? bit * of_outer : bit;
    if ((bits & mask) != 0) return false;
    bits |= mask;
    return true;
  }
};

namespace detail {

template <typename Number>
void say_overdue(const Context<Number>& c, const LimitFlight<Number>& flight, Waiting state, Until until,
                 Finding& f) {
  using W = Work<Number>;
  say_about(c, flight, f);
  const std::string who = c.pair(flight.i, flight.j);
  if (state == Waiting::lost_a_tie) {
    f.reading = readings::kOrder;
    f.message = fmt::format("{} reaches its {} limit at exactly this moment and comes first by rank and ids",
                            who, flight.limit());
    return;
  }
  const Due<W> expected = due(flight.q, flight.asked);
  const std::string when =
      fmt::format("{} after {}", shown(expected.latest), c.shown_time(flight.pair.start));
  if (until == Until::ever) {
    f.message = fmt::format("{} is due at its {} limit {}, but no more events are claimed", who,
                            flight.limit(), when);
  } else if (expected.latest < flight.dt) {
    f.message = fmt::format("{} was due at its {} limit {} before, {}", who, flight.limit(),
                            shown(W(flight.dt - expected.latest)), when);
  } else {
    f.message =
        fmt::format("{} was due at its {} limit {}, by less than rounding before {}", who, flight.limit(),
                    when, until == Until::duration ? "the end" : "what happened meanwhile");
  }
}

template <typename Number>
Waiting waiting(const Context<Number>& c, const LimitFlight<Number>& flight, StepNumber since,
                const Happening<Number>& happening) {
  if constexpr (std::is_same_v<Number, double>) {
    if (c.certified()) {
      const auto turn = certified_turn(c, flight.pair, flight.i, flight.j, flight.asked,
                                       certified_time(c, flight.pair, flight.asked));
      if (!turn) return Waiting::not_due;
      return certified_waiting(c, *turn, flight.asked.outer, since, happening, [&c, flight](Finding& f) {
        say_overdue(c, flight, Waiting::overdue, Until::duration, f);
      });
    }
  }
  return computed_waiting(c, flight.q, flight.asked, flight.dt, c.time_error(happening.t));
}

}  // namespace detail

/// Judges a pair at one limit over its flight until `until`; it waits since the step `since`.
template <typename Number>
Asked judge_limit(const Context<Number>& c, const LimitFlight<Number>& flight, bool is_asked,
                  StepNumber since, const Happening<Number>& happening, Told& told) {
  Asked result;
  const bool outer = flight.asked.outer;
  const Waiting state = is_asked ? detail::waiting(c, flight, since, happening) : Waiting::not_due;
  if ((state == Waiting::overdue || state == Waiting::lost_a_tie) && told.say(Told::overdue, outer)) {
    result.earliest = false;
    c.tally.demand(Rule::earliest, false,
                   [&](Finding& f) { detail::say_overdue(c, flight, state, happening.until, f); });
  }
  if (state == Waiting::undecided && told.say(Told::undecided, outer)) {
    result.earliest = false;
    c.tally.undecided(Rule::earliest, [&](Finding& f) {
      detail::say_about(c, flight, f);
      f.message = fmt::format("{} grazes its {} limit by less than the rounding of the trace's scalar",
                              c.pair(flight.i, flight.j), flight.limit());
    });
  }
  if (happening.until == Until::ever || told.said(Told::beyond, outer)) return result;
  result.bounds = detail::judge_bounds(c, flight, is_asked, c.time_error(happening.t));
  if (!result.bounds) told.say(Told::beyond, outer);
  return result;
}

/// Judges the flight of a pair, i < j, until a moment, at both limits but the one that is happening; in a
/// periodic box with every image on the way. A tether holds the image that is nearest at the start.
template <typename Number>
Asked judge_pair(const Context<Number>& c, int i, int j, const Instant<Number>& until, StepNumber since,
                 const Happening<Number>& happening, Told& told) {
  using W = Work<Number>;
  const Model<Number>& model = c.model;
  const PairRules<Number>& rules = model.rules.of(i, j);
  const bool tethered = model.tethered(i, j);
  Asked result;
  if ((!rules.blocks && !tethered) || model.groups.together(i, j)) return result;
  const Instant<Number>& start = std::max(model.flight(i).since, model.flight(j).since);
  if (until < start) return result;
  const W dt = elapsed(start, until);
  const auto judge = [&](const PairFlight<Number>& pair, const LimitAsked<W>& asked, bool is_asked) {
    LimitFlight<Number> flight{
        i, j, pair, asked, quadratic_of(pair.relative(), asked.L, c.u(), c.timing, c.scale()), dt};
    // In a periodic box a pair that has rebounded meets another image, if one, and from afar (D28).
    if (asked.responded && !asked.outer)
      is_asked = is_asked && flight.q.c > flight.q.q_error &&
                 detail::exact_sign(pair.u_i, pair.u_j, pair.v_i, pair.v_j, pair.image, pair.edges) < 0;
    const Asked one = judge_limit(c, flight, is_asked, since, happening, told);
    result.earliest = result.earliest && one.earliest;
    result.bounds = result.bounds && one.bounds;
  };
  const Vec<Number> met = happening.is(i, j, false) ? model.nearest_image(i, j, happening.t) : Vec<Number>{};
  if (rules.blocks) {
    const bool responded = model.responded(i, j, false);
    const auto images = images_on_the_way(model, i, j, dt, W(rules.inner));
    if (!images) c.tally.not_judged(Rule::earliest, kTooManyImages);
    const std::span<const Vec<Number>> judged = images ? std::span(*images) : std::span<const Vec<Number>>{};
    for (const Vec<Number>& image : judged) {
      const bool happens = happening.is(i, j, false) && image == met;
      judge(pair_flight(model, i, j, image), {false, W(rules.inner), responded && model.edges.has_value()},
            !happens && (!responded || model.edges));
    }
  }
  if (tethered) {
    judge(pair_flight(model, i, j, model.nearest_image(i, j, start)),
          {true, W(rules.outer), model.responded(i, j, true)}, !happening.is(i, j, true));
  }
  return result;
}

}  // namespace tps::check
