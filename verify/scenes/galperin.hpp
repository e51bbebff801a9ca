// Galperin's billiard, whose collisions count the digits of π.
#pragma once

#include "verify/scenes/builder.hpp"

namespace tps {

struct GalperinParams {
  int digits = 2;
  double speed = 1;
};

/// A wall of infinite mass, a ball of mass 1 at rest, and a ball of mass 100^digits that moves towards both
/// with speed
/// 1. The number of collisions is the integer part of 10^digits·π (G. Galperin, "Playing pool with π", 2003).
/// Positions and radii are exact in binary.
Scene build_galperin(const GalperinParams& params);
SceneBuilder galperin_builder();

}  // namespace tps
