// Walls in a picture.
#pragma once

#include <string>

#include "reference/scene/scene.hpp"
#include "verify/draw/view.hpp"

namespace tps {

/// Boxes and spheres as outlines, at the time of the picture; planes that stand upright on it as lines across
/// it. Planes that are seen from above, or leaning, are not drawn.
std::string wall_elements(const Scene& scene, const View& view, double time);

}  // namespace tps
