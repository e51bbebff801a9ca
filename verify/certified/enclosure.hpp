// A real number between doubles. Heavy header: only sources of this folder include it.
#pragma once

#include "verify/certified/certified_response.hpp"
#include "verify/certified/real.hpp"

namespace tps::certified {

/// The doubles around a real number, and the nearest one. Where the working precision does not tell the
/// nearest, this is a doubt of it.
Enclosure enclosure(const Real& x);

EnclosedVector enclosure(const RealVector& x);

}  // namespace tps::certified
