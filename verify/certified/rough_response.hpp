// Friction after Walton on real numbers (docs/effects.md, "Rotation and friction"). Heavy header: only
// sources of this folder include it.
#pragma once

#include "verify/certified/certified_response.hpp"

namespace tps::certified {

/// The rebound of rough_impulse, at the working precision: dp, velocities and spins after it, and whether the
/// surfaces stick. Everything but a sliding impulse is exact: it has the one root |r|.
Response rough_response(const operations::Input& input);

}  // namespace tps::certified
