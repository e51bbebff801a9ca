// Rules order, states and end under drag: the time printed beside the clock s. docs/check.md, "Drag".
#pragma once

#include <algorithm>
#include <limits>

#include "verify/exact/drag_time.hpp"
#include "verify/trace_check/context.hpp"

namespace tps::check {

/// A double of the check, or one of its wide numbers, exactly.
template <typename Number>
Dyadic lifted(const Instant<Number>& t) {
  return dyadic(t.hi) + dyadic(t.lo);
}

/// Whether a time has the clock s: γs < 1.
inline bool is_reached(double gamma, const Dyadic& s) {
  return (Dyadic{1, 0} - dyadic(gamma) * s).sign() > 0;
}

/// How a clock s stands to the one that a time T makes, (1 − e^{−γT})/γ, where T may be off by `of_time` and
/// s by 8u/γ, u of double at least: times are printed as doubles whatever the scalar is. docs/check.md, "A
/// minimal trace".
struct ClockOfTime {
  bool too_late, too_early;
  bool says_nothing;  ///< s = 0 would do as well, of a T above 0

  bool fits() const { return !too_late && !too_early; }
};

/// Roundings of double, or of a narrower scalar.
template <typename Number>
Work<Number> u_of_times(const Context<Number>& c) {
  return std::max(c.u(), Work<Number>(std::numeric_limits<double>::epsilon() / 2));
}

template <typename Number>
ClockOfTime clock_of_time(const Context<Number>& c, const Dyadic& s, const Dyadic& T,
                          const Work<Number>& of_time) {
  using W = Work<Number>;
  const double gamma = c.model.scene.drag->gamma;
  const Dyadic off = dyadic(W(c.scale() * W(8) * u_of_times(c) / W(gamma)));
  const Dyadic blur = dyadic(W(c.scale() * of_time));
  const auto later_than = [&](const Dyadic& clock, const Dyadic& time) {
    return !is_reached(gamma, clock) || exact::compare_drag_time(gamma, clock, time) == exact::Sign::positive;
  };
  const auto earlier_than = [&](const Dyadic& clock, const Dyadic& time) {
    return is_reached(gamma, clock) && exact::compare_drag_time(gamma, clock, time) == exact::Sign::negative;
  };
  const Dyadic least = s - off, most = s + off;
  return {least.sign() > 0 && later_than(least, T + blur), most.sign() < 0 || earlier_than(most, T - blur),
          T.sign() > 0 && later_than(off, T)};
}

/// t and s of an event of a minimal trace, either of which may be computed from the other: a logarithm within
/// two ulps and its quotient are worth 6u of T, the two roundings of t and its start 2u(|T| + |start|).
template <typename Number>
void judge_minimal_drag_time(const Context<Number>& c, Rule rule, const Instant<Number>& s, double time) {
  using W = Work<Number>;
  using std::abs;
  const double start = c.model.scene.start_time;
  const W T(time - start);
  const W of_time = u_of_times(c) * (W(8) * abs(T) + W(2) * abs(W(start)));
  const bool fits = clock_of_time(c, lifted(s), dyadic(time) - dyadic(start), of_time).fits();
  c.tally.demand(rule, fits, [&](Finding& f) {
    f.message =
        fmt::format("the time {:.17g} is not start − ln(1 − γs)/γ at s = {}", time, shown(W(s.hi), 17));
  });
}

/// The time of an event or a state is the double nearest to start − ln(1 − γs)/γ, and there is one: γs < 1.
/// Of minimal traces it is any evaluation of it.
template <typename Number>
void judge_drag_time(const Context<Number>& c, Rule rule, const Instant<Number>& s,
                     const std::optional<double>& time) {
  const Scene& scene = c.model.scene;
  if (!scene.drag || !time) return;
  const double gamma = scene.drag->gamma;
  const bool happens = is_reached(gamma, lifted(s));
  c.tally.demand(rule, happens, [&](Finding& f) {
    f.message = fmt::format("γ s = {} is not below 1: under drag it never comes to that",
                            shown(Work<Number>(gamma) * Work<Number>(s.hi)));
  });
  if (!happens) return;
  if (c.minimal) return judge_minimal_drag_time(c, rule, s, *time);
  const bool nearest = exact::is_nearest_drag_time(gamma, lifted(s), scene.start_time, *time);
  c.tally.demand(rule, nearest, [&](Finding& f) {
    f.message = fmt::format("the time {:.17g} is not the double nearest to start − ln(1 − γs)/γ at s = {}",
                            *time, shown(Work<Number>(s.hi), 17));
  });
}

/// The clock of the end of a minimal trace is any evaluation of (1 − e^{−γT})/γ, T being what its t is after
/// the start: off by 2u(|T| + |start|).
template <typename Number>
void judge_minimal_drag_end(const Context<Number>& c, const EndLine<Number>& end) {
  using W = Work<Number>;
  using std::abs;
  const W of_time = W(2) * u_of_times(c) * (abs(W(end.duration->hi)) + abs(W(c.model.scene.start_time)));
  const ClockOfTime clock = clock_of_time(c, lifted(end.t), lifted(*end.duration), of_time);
  c.tally.demand(Rule::end, clock.fits(), [&](Finding& f) {
    f.message = fmt::format("the clock s = {} is not that of the end after {}: s = (1 − e^{{−γT}})/γ is {}",
                            shown(W(end.t.hi)), shown(W(end.duration->hi)), clock.too_late ? "less" : "more");
  });
  if (clock.says_nothing && clock.fits())
    c.tally.not_judged(Rule::end, "s of an end for which 1 − e^{−γT} is below its rounding");
}

/// The clock of an end by duration is the last number of the scalar (of double for a wider one) before the
/// time that is printed.
template <typename Number>
void judge_drag_end(const Context<Number>& c, const EndLine<Number>& end) {
  const Scene& scene = c.model.scene;
  if (!scene.drag) return;
  if (!end.duration) return judge_drag_time(c, Rule::end, end.t, end.time);
  if (c.minimal) return judge_minimal_drag_end(c, end);
  const double gamma = scene.drag->gamma;
  const Dyadic duration = lifted(*end.duration);
  const auto s = static_cast<double>(end.t.hi);
  const double above = c.model.precision.digits < std::numeric_limits<double>::digits
                           ? static_cast<double>(std::nextafter(static_cast<float>(s), HUGE_VALF))
                           : std::nextafter(s, HUGE_VAL);
  const auto comes = [&](double clock) {
    if (!std::isfinite(clock)) return false;
    const Dyadic at = dyadic(clock);
    return is_reached(gamma, at) && exact::compare_drag_time(gamma, at, duration) != exact::Sign::positive;
  };
  c.tally.demand(
      Rule::end,
      lifted(end.t).sign() >= 0 && comes(s) && (lifted(end.t) - dyadic(s)).sign() == 0 && !comes(above),
      [&](Finding& f) {
        f.message = fmt::format("the clock s = {:.17g} is not the last one before the end after {}", s,
                                shown(Work<Number>(end.duration->hi), 17));
      });
}

/// The last clock before 1/γ: nothing happens after it.
template <typename Number>
Instant<Number> last_clock(const Context<Number>& c) {
  const double gamma = c.model.scene.drag->gamma;
  constexpr double kLargest = std::numeric_limits<double>::max();
  double s = std::min(rounded_quotient<double>({1, 0}, dyadic(gamma), Rounding::down), kLargest);
  if ((Dyadic{1, 0} - dyadic(gamma) * dyadic(s)).sign() == 0) s = std::nextafter(s, 0.0);
  if (c.model.precision.digits < std::numeric_limits<double>::digits) {
    const auto held = static_cast<float>(s);
    s = static_cast<double>(held) > s ? std::nextafter(held, 0.0F) : held;
  }
  return {Number(s), Number(0)};
}

}  // namespace tps::check
