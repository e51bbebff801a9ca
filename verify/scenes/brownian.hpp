// Vesicles that random impulses keep moving.
#pragma once

#include <cstdint>

#include "verify/scenes/builder.hpp"

namespace tps {

/// Spheres of mass 1 and diameter 1 in a spherical membrane, as in `gas`.
struct BrownianParams {
  int particles = 100;
  double density = 0.2;
  double temperature = 0.1;
  double tau = 0.5;
  double shape = 2;
  double mean = 0.5;
  double restitution = 0.8;
  double duration = 10;
  std::uint64_t seed = 1;
};

/// Nearly at rest at first; what random impulses bring in, inelastic collisions take out.
Scene build_brownian(const BrownianParams& params);
SceneBuilder brownian_builder();

}  // namespace tps
