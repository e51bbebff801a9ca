// Newton's cradle.
#pragma once

#include "verify/scenes/builder.hpp"

namespace tps {

/// Balls of diameter 0.1 and mass 1.
struct CradleParams {
  int particles = 5;
  int moving = 1;
  double restitution = 1;
  double duration = 1;
};

/// Touching balls at 0.1·i, which no binary number hits exactly: neighbours overlap or gape by rounding, and
/// the scene is accepted as one of contacts. The first `moving` of them have velocity 1; elastically, as many
/// leave at the other end. Throws std::invalid_argument when more move than there are.
Scene build_cradle(const CradleParams& params);
SceneBuilder cradle_builder();

}  // namespace tps
