// Where the times of a run end: those that can be printed under drag, and those that a resumed run has behind
// it.
#pragma once

#include <limits>
#include <stdexcept>
#include <string>

#include "reference/text/number_text.hpp"
#include "reference/trace/event_line.hpp"

namespace tps {

/// Whether γ s ≥ 1: under drag the clock never comes to s. A time beyond the scalar's range, `never()`, is
/// anything above it.
template <typename Scalar>
bool is_never_reached(double gamma, const Time<Scalar>& s) {
  using std::ldexp;
  using Limits = std::numeric_limits<Scalar>;
  constexpr int kInverseOfLeastGamma = 1074;
  const bool is_wide = Limits::digits > std::numeric_limits<double>::digits;
  if (is_wide && s.hi >= ldexp(Scalar(1), kInverseOfLeastGamma)) return true;
  const Dyadic at = is_finite(s.hi) ? whole(s) : dyadic((Limits::max)());
  return drag_factor(gamma, at).sign() <= 0;
}

/// Whether a run for ever with drag has times that nobody can print: the number after `last`, its last clock
/// with a time that can be, is still below 1/γ. Only where 1/γ is near the largest double (in float: float)
/// or above it.
template <typename Scalar>
bool has_times_behind(const Scene& scene, double duration, const Time<Scalar>& last) {
  if (!scene.drag || is_finite(duration)) return false;
  const auto s = static_cast<double>(last.hi);
  const double above = std::numeric_limits<Scalar>::digits < std::numeric_limits<double>::digits
                           ? static_cast<double>(std::nextafter(static_cast<float>(s), HUGE_VALF))
                           : std::nextafter(s, HUGE_VAL);
  return !std::isfinite(above) || !is_never_reached(scene.drag->gamma, Time<double>{above, 0});
}

/// A run cannot end before the full state from which it would go on.
class EndsBeforeState : public std::runtime_error {
 public:
  /// @param now  of the state, as people read it: since the start
  EndsBeforeState(double until_in, std::string now_in)
      : std::runtime_error("the end " + write_shortest(until_in) + " is before the state at " + now_in),
        until(until_in),
        now(std::move(now_in)) {}

  double until;
  std::string now;
};

/// Throws EndsBeforeState where the last moment on the run's clock, `horizon`, is before `now`. One that is
/// the same as `now` is an end: what else is due then still happens.
template <typename Scalar>
void require_end_ahead(const Scene& scene, double until, const Time<Scalar>& horizon,
                       const Time<Scalar>& now) {
  if (!(horizon < now)) return;
  const double t = scene.drag ? drag_time(scene.drag->gamma, whole(now), 0) : static_cast<double>(now.hi);
  throw EndsBeforeState(until, t > until ? write_shortest(t) : exact_time(0, now));
}

}  // namespace tps
