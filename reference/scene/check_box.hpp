// What a periodic box has to be, and what it goes together with.
#pragma once

#include "reference/scene/scene.hpp"
#include "reference/scene/scene_source.hpp"

namespace tps {

/// Whether a periodic edge is wider than two interaction distances by a 64th of itself: else two images could
/// be met at once.
bool is_wide_enough(double edge, double interaction_distance);

/// Reports a box that is too narrow, particles that start outside of it, walls across it, and what has no
/// meaning in it. REQUIRES that species, pairs, particles and walls are sound.
void check_box(const Scene& scene, SceneSource& source);

}  // namespace tps
