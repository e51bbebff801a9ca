// Rough spheres in a spherical membrane.
#pragma once

#include <cstdint>

#include "verify/scenes/builder.hpp"

namespace tps {

/// Spheres of mass 1 and diameter 1 in a smooth spherical membrane, as in `gas`, that rub each other.
struct RoughParams {
  int particles = 60;
  double density = 0.3;
  double temperature = 1;
  double restitution = 0.9;
  double mu = 0.5;
  double beta0 = 0;
  double duration = 10;
  std::uint64_t seed = 1;
};

/// Spins of every second sphere start at ±1 about z, so that the first collisions show them. With restitution
/// and beta0 1 and a large mu nothing is lost, and motion and spins come to share the energy.
Scene build_rough(const RoughParams& params);
SceneBuilder rough_builder();

}  // namespace tps
