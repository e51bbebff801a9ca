// A flight in doubles, for a first look at it beside others.
#pragma once

#include <cmath>
#include <limits>

#include "verify/trace_check/clear.hpp"
#include "verify/trace_check/number.hpp"

namespace tps::check {

struct FlightInDoubles {
  std::array<double, 3> position{}, velocity{};
  Instant<double> since;
  double size = 0, speed = 0;  ///< as a StraightLine has them

  /// The line by a moment, looked at for so much longer.
  StraightLine until(const Instant<double>& t, double longer) const {
    return {position.data(), velocity.data(), (t.hi - since.hi) + (t.lo - since.lo) + longer, size, speed};
  }
};

template <typename Number>
Instant<double> rough(const Instant<Number>& t) {
  const double hi = static_cast<double>(t.hi);
  return {hi, static_cast<double>(Number(t.hi - Number(hi)) + t.lo)};
}

/// `blur` and `drift` are how far position and velocity may be off. Below 2^-45 of the sizes they move
/// squares of distances by less than a quarter of the share that first looks stay away from limits, 2^-40 at
/// least.
template <typename Number>
FlightInDoubles in_doubles(const Vec<Number>& position, const Vec<Number>& velocity,
                           const Instant<Number>& since, double blur = 0, double drift = 0) {
  FlightInDoubles f;
  for (std::size_t k = 0; k < 3; ++k) {
    f.position[k] = static_cast<double>(position[k]);
    f.velocity[k] = static_cast<double>(velocity[k]);
    f.size += std::fabs(f.position[k]);
    f.speed += std::fabs(f.velocity[k]);
  }
  f.since = rough(since);
  if (!(blur <= 0x1p-45 * f.size && drift <= 0x1p-45 * f.speed))
    f.size = std::numeric_limits<double>::quiet_NaN();
  return f;
}

}  // namespace tps::check
