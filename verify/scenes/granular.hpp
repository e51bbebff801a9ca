// A granular gas that cools.
#pragma once

#include <cstdint>

#include "verify/scenes/builder.hpp"

namespace tps {

/// Inelastic spheres of mass 1 and diameter 1 in an elastic spherical membrane, as in `gas`.
struct GranularParams {
  int particles = 100;
  double density = 0.2;
  double temperature = 1;
  double restitution = 0.9;
  double mu = 0.3;
  double beta0 = 0.3;
  double duration = 20;
  std::uint64_t seed = 1;
};

/// With mu above 0 spheres rub each other and start without spin; with mu = 0 they are smooth, keep none, and
/// cool by Haff's law until they cluster.
Scene build_granular(const GranularParams& params);
SceneBuilder granular_builder();

}  // namespace tps
