// The surfaces of a scene's walls: planes and spheres, each with one question for a particle.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reference/scene/scene.hpp"

namespace tps {

/// A part of a wall. A box has two planes an axis, which are told apart as faces: 2k at the low end of axis
/// k, 2k + 1 at the high one.
struct Surface {
  enum class Kind {
    plane,    ///< n·(x − p) ≥ L
    outside,  ///< |x − p| ≥ L, of a sphere
    inside,   ///< |x − p| ≤ L, of a sphere
  };
  Kind kind;
  std::size_t wall;         ///< of Scene::walls
  std::optional<int> face;  ///< of a box
  Coordinates point;        ///< p, at the start
  Coordinates normal;       ///< n, of a plane, towards the particles
  double radius;            ///< of a sphere
  double c_rebound;
  Coordinates velocity;
};

/// All surfaces, in the order of the walls, faces ascending. What names a surface in a run is its place here.
std::vector<Surface> surfaces(const Scene& scene);

/// L, the distance from the surface's plane or centre at which a particle of a radius touches it: the radius,
/// the sum or the difference of the two, rounded once.
double touching_distance(const Surface& surface, double radius);

/// "wall 0", "wall 1, face 2 (low y)".
std::string surface_name(const Surface& surface);

/// The common velocity of all walls; nothing where there is none or they differ.
std::optional<Coordinates> velocity_of_walls(const Scene& scene);

}  // namespace tps
