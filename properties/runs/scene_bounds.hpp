// Where the particles of a scene start, from the lowest to the highest coordinate.
#pragma once

#include <algorithm>

#include "properties/runs/judge.hpp"
#include "reference/scene/scene.hpp"

namespace tps::properties::runs {

inline std::size_t at(int k) {
  return static_cast<std::size_t>(k);
}

inline Point point_of(const Coordinates& x) {
  return {x[0], x[1], x[2]};
}

struct Bounds {
  Coordinates low{}, high{};
};

inline Bounds bounds_of(const Scene& scene) {
  Bounds bounds{scene.particles.front().position, scene.particles.front().position};
  for (const Particle& p : scene.particles) {
    for (std::size_t k = 0; k < 3; ++k) {
      bounds.low[k] = std::min(bounds.low[k], p.position[k]);
      bounds.high[k] = std::max(bounds.high[k], p.position[k]);
    }
  }
  return bounds;
}

inline double largest_radius(const Scene& scene) {
  double radius = 0;
  for (const Species& species : scene.species) radius = std::max(radius, species.radius);
  return radius;
}

inline double longest_limit(const Scene& scene) {
  double longest = 0;
  for (const PairLaw& law : scene.pairs) {
    if (law.blocking) longest = std::max(longest, law.blocking->distance);
    if (law.tethering) longest = std::max(longest, law.tethering->distance);
  }
  return longest;
}

}  // namespace tps::properties::runs
