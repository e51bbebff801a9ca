// The numbers in which laws of runs are judged: wider than those of the runs, and read off their traces.
#pragma once

#include <string_view>

#include "reference/equations/vector.hpp"

namespace tps::properties::runs {

/// What a law computes with: 64 bits, where a run in double has 53. Planar scenes are judged in space, z = 0.
using Real = long double;
using Point = Vector<Real, 3>;

/// A time to twice the precision of Real, as a run keeps it: hi + lo. Traces give it without rounding.
struct Instant {
  Real hi = 0, lo = 0;
  friend bool operator==(const Instant&, const Instant&) = default;
};

/// later − earlier. Exact to 2^-64 of itself where hi + lo holds all of both.
inline Real elapsed(const Instant& earlier, const Instant& later) {
  return (later.hi - earlier.hi) + (later.lo - earlier.lo);
}

/// The number that a hexadecimal float of any length spells: its first 64 bits, and the first 64 of what is
/// left, however far behind: late in a run the lo of a time is many orders below its hi. "inf" is infinite.
/// Throws std::invalid_argument for any other text.
Instant read_instant(std::string_view hex);

/// The same, rounded to one part.
Real read_real(std::string_view hex);

/// An error of a law is allowed as many units of this as its derivation counts, u of the run's scalar; where
/// the judge's own roundings (2^-64 each, a few dozen of them) would count, 2^-58 takes their place.
Real judged_roundoff(std::string_view scalar);

/// What u is multiplied with for the terms of second order and the judge's own roundings.
inline constexpr Real kSpare = 1.03L;

}  // namespace tps::properties::runs
