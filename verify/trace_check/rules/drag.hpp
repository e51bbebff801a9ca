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

/// The time of an event or a state is the double nearest to start − ln(1 − γs)/γ, and there is one: γs < 1.
/// Of minimal traces, whose logarithm may be any library's, only the latter is judged.
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
  if (c.minimal) {
    c.tally.not_judged(rule, "times of a minimal trace with drag, beside their s");
    return;
  }
  const bool nearest = exact::is_nearest_drag_time(gamma, lifted(s), scene.start_time, *time);
  c.tally.demand(rule, nearest, [&](Finding& f) {
    f.message = fmt::format("the time {:.17g} is not the double nearest to start − ln(1 − γs)/γ at s = {}",
                            *time, shown(Work<Number>(s.hi), 17));
  });
}

/// The clock of the end of a minimal trace is any evaluation of (1 − e^{−γT})/γ, T being what its t is after
/// the start: within 8u/γ for a T that is off by 2u(|T| + |start|). docs/check.md, "A minimal trace".
template <typename Number>
void judge_minimal_drag_end(const Context<Number>& c, const EndLine<Number>& end) {
  using W = Work<Number>;
  using std::abs;
  const double gamma = c.model.scene.drag->gamma;
  // The s of an end, and the time that is printed, may be doubles whatever the scalar.
  const W u = std::max(c.u(), W(std::numeric_limits<double>::epsilon() / 2));
  const W of_time = W(2) * u * (abs(W(end.duration->hi)) + abs(W(c.model.scene.start_time)));
  const Dyadic off = dyadic(W(c.scale() * W(8) * u / W(gamma)));
  const Dyadic blur = dyadic(W(c.scale() * of_time));
  const Dyadic s = lifted(end.t), T = lifted(*end.duration);
  const Dyadic least = s - off, most = s + off;
  const bool too_late =
      least.sign() > 0 && (!is_reached(gamma, least) ||
                           exact::compare_drag_time(gamma, least, T + blur) == exact::Sign::positive);
  const bool too_early =
      most.sign() < 0 ||
      (is_reached(gamma, most) && exact::compare_drag_time(gamma, most, T - blur) == exact::Sign::negative);
  c.tally.demand(Rule::end, !too_late && !too_early, [&](Finding& f) {
    f.message = fmt::format("the clock s = {} is not that of the end after {}: s = (1 − e^{{−γT}})/γ is {}",
                            shown(W(end.t.hi)), shown(W(end.duration->hi)), too_late ? "less" : "more");
  });
  const bool says_nothing =
      T.sign() > 0 &&
      (!is_reached(gamma, off) || exact::compare_drag_time(gamma, off, T) == exact::Sign::positive);
  if (says_nothing && !too_late && !too_early) {
    c.tally.not_judged(Rule::end, "s of an end for which 1 − e^{−γT} is below its rounding");
  }
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
