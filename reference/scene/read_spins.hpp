#pragma once

#include "reference/scene/scene.hpp"
#include "reference/scene/scene_source.hpp"

namespace tps {

/// Reads the angular velocities that particles of a scene start with, three components in space and one in
/// the plane; reports lists of another length. REQUIRES the scene's particles read, and nothing wrong with
/// them.
void read_spins(Scene& scene, SceneSource& source);

}  // namespace tps
