// A surface of a wall in the numbers of a trace.
#pragma once

#include <vector>

#include "reference/scene/surfaces.hpp"
#include "verify/trace_check/pair_rules.hpp"

namespace tps::check {

template <typename Number>
struct WallModel {
  Surface surface;
  Vec<Number> point, normal, velocity;  ///< at the start of the run
  Number c_rebound;
  std::vector<Number> distances;  ///< L, by species

  Vec<Number> low = {}, high = {};  ///< the ends of a box, of its outside

  /// Along the axes on which the distance from a part of a box is measured; else all of it.
  template <typename Coordinate>
  Vec<Coordinate> measured(Vec<Coordinate> x) const {
    for (std::size_t k = 0; surface.region && k < 3; ++k) {
      if (!surface.region->measures(k)) x[k] = Coordinate(0);
    }
    return x;
  }
  bool is_plane() const { return surface.kind == Surface::Kind::plane; }
  bool is_inside() const { return surface.kind == Surface::Kind::inside; }
};

template <typename Number>
std::vector<WallModel<Number>> wall_models(const Scene& scene, const Precision<Number>& precision) {
  const auto lifted = [&](const Coordinates& x) {
    return Vec<Number>{
        {stored<Number>(x[0], precision), stored<Number>(x[1], precision), stored<Number>(x[2], precision)}};
  };
  std::vector<WallModel<Number>> walls;
  for (const Surface& surface : surfaces(scene)) {
    walls.push_back({surface,
                     lifted(surface.point),
                     lifted(surface.normal),
                     lifted(surface.velocity),
                     stored<Number>(surface.c_rebound, precision),
                     {}});
    if (surface.region) {
      walls.back().low = lifted(surface.region->low);
      walls.back().high = lifted(surface.region->high);
    }
    for (const Species& species : scene.species)
      walls.back().distances.push_back(stored<Number>(touching_distance(surface, species.radius), precision));
  }
  return walls;
}

}  // namespace tps::check
