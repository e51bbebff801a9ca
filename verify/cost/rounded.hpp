// How the figures of a study are written.
#pragma once

#include <cmath>

namespace tps::cost {

/// Four digits: more than any of these figures is good for.
inline double rounded(double x) {
  if (x == 0 || !std::isfinite(x)) return x;
  const double places = 3 - std::floor(std::log10(std::fabs(x)));
  const double unit = std::pow(10.0, std::fabs(places));
  return places >= 0 ? std::round(x * unit) / unit : std::round(x / unit) * unit;
}

}  // namespace tps::cost
