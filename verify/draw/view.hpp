// From the coordinates of a scene to those of a picture.
#pragma once

#include <array>
#include <vector>

#include "reference/scene/scene.hpp"

namespace tps {

/// A particle as the picture has it: pixels, y downwards; depth 0 is the farthest, 1 the nearest.
struct Seen {
  double x = 0;
  double y = 0;
  double radius = 0;
  double depth = 1;
};

/// All particles fitted into a square of `size` pixels with a margin. A particle of radius 0, or one too
/// small to be seen, is drawn at least 1.5 pixels large.
std::vector<Seen> fit_to_picture(const Scene& scene, const std::vector<std::array<double, 3>>& positions,
                                 double size);

}  // namespace tps
