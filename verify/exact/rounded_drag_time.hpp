// The certified answer to `drag_time`: t = −ln(1 − γs)/γ, correctly rounded. docs/exact.md, "The time of a
// scene with drag".
#pragma once

namespace tps::exact {

/// Whether the clock s is ever reached, γ s < 1. REQUIRES finite numbers.
bool drag_clock_is_reached(double gamma, double s);

struct DragTime {
  double t;             ///< the double nearest to t(s); infinity beyond the largest
  bool settled = true;  ///< whether that is proven; else 2^13 bits do not tell it from a neighbour
};

/// The certified answer to `drag_time`. REQUIRES γ > 0, s ≥ 0, γ s < 1.
///
/// Law: t is what comparisons with the middles of neighbouring doubles leave, wherever they began.
DragTime rounded_drag_time(double gamma, double s);

}  // namespace tps::exact
