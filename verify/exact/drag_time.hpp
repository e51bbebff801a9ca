// The time of a scene with drag, compared exactly: t = −ln(1 − γs)/γ against any dyadic number.
// docs/exact.md, "The time of a scene with drag".
#pragma once

#include "reference/equations/dyadic.hpp"
#include "verify/exact/verdict.hpp"

namespace tps::exact {

/// The sign of t(s) − t. It is zero only for s = t = 0: else ln(1 − γs) is irrational (Lindemann), so that
/// enough bits of it always tell. `uncertain` where 2^13 of them do not.
/// REQUIRES γ > 0, s ≥ 0, γ s < 1.
Sign compare_drag_time(double gamma, const Dyadic& s, const Dyadic& t);

/// Whether `rounded` is the double nearest to start + t(s); either neighbour where that cannot be told.
/// REQUIRES as above, finite numbers.
bool is_nearest_drag_time(double gamma, const Dyadic& s, double start, double rounded);

/// Half-way between two doubles, an infinity standing for 2^1024 of its sign.
Dyadic middle_of(double x, double y);

}  // namespace tps::exact
