// The clock of a scene with drag in real arithmetic. Heavy header: only sources of laws include it.
#pragma once

#include "properties/wide.hpp"

namespace tps::properties {

/// −ln(1 − z), without the digits that 1 − z would lose. REQUIRES z < 1.
inline Wide minus_log(const Wide& z) {
  // What the series leaves out is below z⁵/6 < 2^-500 of it; above, 1 − z keeps 400 bits.
  if (z < ldexp(Wide(1), -100))
    return z * (1 + z * (Wide(1) / 2 + z * (Wide(1) / 3 + z * (Wide(1) / 4 + z / 5))));
  return -log(Wide(1 - z));
}

/// t of a clock s: −ln(1 − γs)/γ. REQUIRES z = γs < 1.
inline Wide time_of_clock(const Wide& gamma, const Wide& z) {
  return minus_log(z) / gamma;
}

}  // namespace tps::properties
