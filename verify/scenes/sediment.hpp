// Spheres under gravity in a spherical membrane.
#pragma once

#include <cstdint>

#include "verify/scenes/builder.hpp"

namespace tps {

/// Spheres of mass 1 and diameter 1 in a spherical membrane, as in `gas`.
struct SedimentParams {
  int particles = 60;
  double density = 0.2;
  double temperature = 1;
  double gravity = 1;
  double every = 0.05;
  double restitution = 1;
  double tau = 0;
  double duration = 10;
  std::uint64_t seed = 1;
};

/// Gravity along −z. With `tau` above 0 a thermostat holds kT, and heights are distributed by the barometric
/// law but for the volume of the spheres.
Scene build_sediment(const SedimentParams& params);
SceneBuilder sediment_builder();

}  // namespace tps
