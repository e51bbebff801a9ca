// Rules earliest and bounds: what a pair that is not at its event must not have done meanwhile.
#pragma once

#include "verify/trace_check/context.hpp"
#include "verify/trace_check/pair_flight.hpp"
#include "verify/trace_check/replay.hpp"
#include "verify/trace_check/rules/readings.hpp"

namespace tps::check {

/// The event by which a pair is asked: when it happens and, for certified order, which exact moment that
/// rounds.
template <typename Number>
struct Happening {
  Instant<Number> t;
  std::optional<Moment> moment;
  int i = -1, j = -1;  ///< of a collision
  bool outer = false;
  bool forever = false;  ///< no event at all: there is none ahead

  bool is(int a, int b, bool at_outer) const { return a == i && b == j && outer == at_outer; }
};

/// What is left open or wrong of a pair at one of its limits.
enum class Waiting { not_due, undecided, overdue, lost_a_tie };

namespace detail {

/// Exact: before the event that happens, or at exactly its moment with smaller ids. REQUIRES
/// happening.moment.
inline Waiting certified_waiting(const Context<double>& c, const PairFlight<double>& pair, int i, int j,
                                 const LimitAsked<long double>& asked, const Happening<double>& happening) {
  Moment moment{pair.start.hi, pair.start.lo, timing_query(pair, asked.outer, static_cast<double>(asked.L)),
                1};
  if (!valid(*moment.query)) return Waiting::not_due;
  const TimingVerdict verdict = c.exact.answer(*moment.query).verdict;
  if (!occurs(verdict)) return Waiting::not_due;
  if (asked.responded) {
    if (verdict != TimingVerdict::hit && verdict != TimingVerdict::turning) return Waiting::not_due;
    moment.multiple = verdict == TimingVerdict::turning ? 2 : 1;
  }
  const std::weak_ordering order = c.exact.order(moment, *happening.moment);
  if (order < 0) return Waiting::overdue;
  const bool ties = order == 0 && happening.i >= 0 && std::tie(i, j) < std::tie(happening.i, happening.j);
  return ties ? Waiting::lost_a_tie : Waiting::not_due;
}

/// Beyond every time that the trace's timing can have computed; undecided where real arithmetic has an event
/// that its rounding need not see.
template <typename Number>
Waiting computed_waiting(const Context<Number>& c, const Quadratic<Work<Number>>& q,
                         const LimitAsked<Work<Number>>& asked, const Work<Number>& dt,
                         const Work<Number>& slack) {
  using std::sqrt;
  using W = Work<Number>;
  const Due<W> expected = due(q, asked);
  if (!expected.can_be_none)
    return expected.latest + slack * c.scale() < dt ? Waiting::overdue : Waiting::not_due;
  if (asked.outer || q.h >= W(0)) return Waiting::not_due;
  const W D = q.discriminant();
  const W exactly = q.c <= W(0) ? W(0) : D > W(0) ? W(q.c / (sqrt(D) - q.h)) : W(dt + W(1));
  return exactly + slack < dt ? Waiting::undecided : Waiting::not_due;
}

template <typename Number>
Waiting waiting(const Context<Number>& c, const PairFlight<Number>& pair, int i, int j,
                const Quadratic<Work<Number>>& q, const LimitAsked<Work<Number>>& asked,
                const Work<Number>& dt, const Happening<Number>& happening) {
  if constexpr (std::is_same_v<Number, double>) {
    if (c.certified() && happening.moment) return certified_waiting(c, pair, i, j, asked, happening);
  }
  return computed_waiting(c, q, asked, dt, c.time_error(happening.t));
}

/// How far beyond the limit the pair came during its flight, as squared distance, less what it began with.
template <typename W>
W excess_of(const Quadratic<W>& q, bool outer, const W& dt) {
  const W zero(0);
  if (outer) return std::max(q.at(dt), q.c) - std::max(zero, q.c);
  const W turning = q.a > zero ? W(-q.h / q.a) : zero;
  const W closest = std::min(std::max(zero, turning), dt);
  return std::min(zero, q.c) - std::min(q.at(closest), q.c);
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

  /// Whether it is new.
  bool say(unsigned bit, bool outer) {
    const unsigned mask = outer ? bit * of_outer : bit;
    if ((bits & mask) != 0) return false;
    bits |= mask;
    return true;
  }
};

/// Judges a pair at one limit over its flight until `until`.
template <typename Number>
Asked judge_limit(const Context<Number>& c, const PairFlight<Number>& pair, int i, int j,
                  const LimitAsked<Work<Number>>& asked, bool is_asked, const Instant<Number>& until,
                  const Happening<Number>& happening, Told& told) {
  using W = Work<Number>;
  using std::sqrt;
  const char* which = asked.outer ? "outer" : "inner";
  const Quadratic<W> q = quadratic_of(pair.relative(), asked.L, c.u(), c.timing, c.scale());
  const W dt = elapsed(pair.start, until);
  Asked result;
  const auto about = [&](Finding& f) {
    f.particles = {c.model.id(i), c.model.id(j)};
    f.equation = "(2)";
    f.replay = replay_of_time(pair, asked.outer, asked.L, c.model.scene.dimension);
  };
  const Waiting state = is_asked ? detail::waiting(c, pair, i, j, q, asked, dt, happening) : Waiting::not_due;
  if ((state == Waiting::overdue || state == Waiting::lost_a_tie) && told.say(Told::overdue, asked.outer)) {
    result.earliest = false;
    c.tally.demand(Rule::earliest, false, [&](Finding& f) {
      about(f);
      if (state == Waiting::lost_a_tie) f.reading = readings::kOrder;
      const Due<W> expected = due(q, asked);
      f.message =
          state == Waiting::lost_a_tie
              ? fmt::format("{} reaches its {} limit at exactly this moment and has the smaller ids",
                            c.pair(i, j), which)
              : fmt::format("{} was due at its {} limit {} before, {} after {}", c.pair(i, j), which,
                            shown(W(dt - expected.latest)), shown(expected.latest), c.shown_time(pair.start));
    });
  }
  if (state == Waiting::undecided && told.say(Told::undecided, asked.outer)) {
    result.earliest = false;
    c.tally.undecided(Rule::earliest, [&](Finding& f) {
      about(f);
      f.message = fmt::format("{} grazes its {} limit by less than the rounding of the trace's scalar",
                              c.pair(i, j), which);
    });
  }
  // A pair that has responded may creep: its relative velocity is known to rounding only.
  const W speeds = length(widened<W>(pair.v_i)) + length(widened<W>(pair.v_j));
  const W unit = q.q_error / (W(6) * c.scale()) +
                 (is_asked && !asked.responded ? W(0) : W(4) * asked.L * c.u() * speeds * dt) +
                 asked.L * c.time_error(until) * length(q.v) / W(3);
  const W excess = detail::excess_of(q, asked.outer, dt);
  if (excess > W(6) * unit * c.scale() && !happening.forever && told.say(Told::beyond, asked.outer)) {
    result.bounds = false;
    const W beyond_limit = asked.outer ? W(sqrt(asked.L * asked.L + excess) - asked.L)
                                       : W(asked.L - sqrt(std::max(W(0), W(asked.L * asked.L - excess))));
    c.tally.within(Rule::bounds, as_double(W(excess / unit)), 6, [&](Finding& f) {
      about(f);
      f.message = fmt::format("{} comes {} beyond its {} limit {} in flight", c.pair(i, j),
                              shown(beyond_limit), which, shown(asked.L));
      f.equation = "(1)";
    });
  }
  return result;
}

namespace detail {

/// Whether plain doubles see that nothing can have happened: the pair stayed clear of both limits by more
/// than they can err.
template <typename Number>
bool is_clear(const Model<Number>& model, int i, int j, const PairRules<Number>& rules, bool tethered,
              const Instant<double>& until) {
  if (model.eager) return false;
  const Flight<double>& a = model.rough_flight(i);
  const Flight<double>& b = model.rough_flight(j);
  const double since_a = (until.hi - a.since.hi) + (until.lo - a.since.lo);
  const double since_b = (until.hi - b.since.hi) + (until.lo - b.since.lo);
  const double together = std::min(since_a, since_b);
  double rr = 0, rv = 0, vv = 0, size = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double r = (b.position[k] + b.velocity[k] * since_b) - (a.position[k] + a.velocity[k] * since_a);
    const double v = b.velocity[k] - a.velocity[k];
    rr += r * r;
    rv += r * v;
    vv += v * v;
    size += std::fabs(a.position[k]) + std::fabs(b.position[k]) + std::fabs(a.velocity[k] * since_a) +
            std::fabs(b.velocity[k] * since_b);
  }
  const double blur = static_cast<double>(a.blur + b.blur);
  if (!(blur == 0) || !(size < 1e100) || !(size > 1e-140)) return false;
  const double before = rr - together * (2 * rv - together * vv);  // squared distance when the flight began
  const double turned = rv > 0 && rv < vv * together ? rr - rv * rv / vv : std::min(rr, before);
  constexpr double kShare = 0x1p-40;  // thousands of roundings
  const auto beyond = [&](const Number& limit) {
    const double L = static_cast<double>(limit);
    return std::pair(L * L, kShare * (size * size + L * L));
  };
  if (rules.blocks) {
    const auto [limit, error] = beyond(rules.inner);
    if (!(turned - limit > error)) return false;
  }
  if (tethered) {
    const auto [limit, error] = beyond(rules.outer);
    if (!(std::max(rr, before) - limit < -error)) return false;
  }
  return true;
}

}  // namespace detail

/// Judges the flight of a pair, i < j, until a moment, at both limits but the one that is happening.
template <typename Number>
Asked judge_pair(const Context<Number>& c, int i, int j, const Instant<Number>& until,
                 const Happening<Number>& happening, Told& told) {
  using W = Work<Number>;
  const Model<Number>& model = c.model;
  const PairRules<Number>& rules = model.rules.of(i, j);
  const bool tethered = model.tethered(i, j);
  Asked result;
  if ((!rules.blocks && !tethered) || model.groups.together(i, j)) return result;
  if (detail::is_clear(model, i, j, rules, tethered, rough(until))) return result;
  const PairFlight<Number> pair = pair_flight(model, i, j);
  if (until < pair.start) return result;
  if (rules.blocks) {
    const bool is_asked = !model.responded(i, j, false) && !happening.is(i, j, false);
    const Asked inner = judge_limit(c, pair, i, j, LimitAsked<W>{false, W(rules.inner), false}, is_asked,
                                    until, happening, told);
    result = inner;
  }
  if (tethered) {
    const LimitAsked<W> asked{true, W(rules.outer), model.responded(i, j, true)};
    const Asked outer = judge_limit(c, pair, i, j, asked, !happening.is(i, j, true), until, happening, told);
    result.earliest = result.earliest && outer.earliest;
    result.bounds = result.bounds && outer.bounds;
  }
  return result;
}

}  // namespace tps::check
