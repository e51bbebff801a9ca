// What walls have to be, and that every particle starts on the right side of them.
#pragma once

#include "reference/scene/scene.hpp"
#include "reference/scene/scene_source.hpp"

namespace tps {

/// Reports what is wrong with the walls themselves.
void check_walls(const Scene& scene, SceneSource& source);

/// Reports the particles of finite mass that start in a wall, decided exactly as starts of pairs are.
/// REQUIRES walls and particles that were read.
void check_starts_at_walls(const Scene& scene, SceneSource& source);

}  // namespace tps
