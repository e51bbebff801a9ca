// The clock of a scene with drag: s = (1 − e^{−γt})/γ, in which motion is straight, and the time t that it
// stands for. docs/effects.md, "Drag".
#pragma once

#include "reference/engine/clock.hpp"
#include "reference/equations/dyadic.hpp"

namespace tps {

/// s(T), rounded down: the largest double below (1 − e^{−γT})/γ, which is no double itself, since e^x of a
/// rational x ≠ 0 is irrational. Below 1/γ for every T. REQUIRES γ > 0 and T ≥ 0, both finite; 0 for T = 0.
///
/// A run of duration T has the events with s ≤ s(T), rounded down. As no double lies between this and s(T),
/// these are the events with t ≤ T for every clock that is a double.
double drag_clock_until(double gamma, double T);

/// The last time since the start that a run with drag can print, start + t being a double: what T = ∞ is to
/// drag_clock_until().
double last_drag_time(double start);

/// 1 − γ s = e^{−γt}, exactly. REQUIRES γ finite.
Dyadic drag_factor(double gamma, const Dyadic& s);

/// The double nearest to start + t(s), t = −ln(1 − γs)/γ. An event has no time where γ s ≥ 1.
/// REQUIRES γ > 0 finite, s ≥ 0, γ s < 1, t(s) ≤ last_drag_time(start).
///
/// Law: within half an ulp of the exact value; nearest, as long as that is farther than 2^−900 of t from
/// the middle of two doubles, and exactly so for γ s < 2^−60 (docs/effects.md).
double drag_time(double gamma, const Dyadic& s, double start);

/// hi + lo as one number.
template <typename Scalar>
Dyadic whole(const Time<Scalar>& t) {
  return dyadic(t.hi) + dyadic(t.lo);
}

}  // namespace tps
