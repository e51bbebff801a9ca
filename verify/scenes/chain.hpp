// A long protein: beads on a string.
#pragma once

#include <cstdint>

#include "verify/scenes/builder.hpp"

namespace tps {

/// Beads of diameter 1 and mass 1; lengths are in bead diameters.
struct ChainParams {
  int particles = 32;
  double tether_distance = 1.5;
  double temperature = 1;
  double c_rebound = 1;
  double c_retract = 1;
  double c_revolve = 1;
  double theta = 45;
  double grouped = 0;
  double duration = 20;
  std::uint64_t seed = 1;
};

/// Beads in a row on the x axis, half-way between touching and taut, each tethered to its neighbours; Maxwell
/// velocities without total momentum. All beads block one another, so that the chain cannot cross itself.
Scene build_chain(const ChainParams& params);
SceneBuilder chain_builder();

}  // namespace tps
