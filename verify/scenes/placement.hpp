// Places for spheres in a ball, without overlap.
#pragma once

#include <vector>

#include "reference/scene/random.hpp"
#include "reference/scene/scene.hpp"

namespace tps {

/// A sphere at a place.
struct Placed {
  Coordinates center{};
  double radius = 0;
};

/// Whether a sphere lies inside the ball of `ball_radius` around the origin and apart from all of `others`.
bool is_free(const Placed& sphere, const std::vector<Placed>& others, double ball_radius);

/// A point uniform in the ball of `ball_radius` around the origin.
Coordinates random_point(RandomStream& stream, double ball_radius);

}  // namespace tps
