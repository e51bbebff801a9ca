// The surfaces of a scene's walls: planes, spheres and, of the outside of a box, its faces, edges and
// corners, each with one question for a particle.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "reference/scene/scene.hpp"

namespace tps {

/// Where the centres are to which one part of a box is the nearest: axis by axis below, between or beyond its
/// ends. The distance from the part is measured along the axes that are not `between`: of one of them it is a
/// face, of two an edge, of three (in the plane of two) a corner.
struct BoxRegion {
  enum class Side { below, between, above };
  std::array<Side, 3> sides;
  Coordinates low, high;  ///< the ends of the box, at the start

  bool measures(std::size_t k) const { return sides[k] != Side::between; }
};

/// A part of a wall. A box has two planes an axis, which are told apart as faces: 2k at the low end of axis
/// k, 2k + 1 at the high one. From outside its edges (in space) and corners follow, by their axes, low before
/// high.
struct Surface {
  enum class Kind {
    plane,    ///< n·(x − p) ≥ L
    outside,  ///< |x − p| ≥ L, of a sphere, or of an edge or a corner of a box along the axes of its region
    inside,  ///< |x − p| ≤ L, of a sphere
  };
  Kind kind;
  std::size_t wall;         ///< of Scene::walls
  std::optional<int> face;  ///< of a box: its part
  Coordinates point;        ///< p, at the start
  Coordinates normal;       ///< n, of a plane, towards the particles
  double radius;            ///< of a sphere
  double c_rebound;
  Coordinates velocity;
  std::optional<BoxRegion> region = {};  ///< of the outside of a box: outside of it this part is not asked
};

/// All surfaces, in the order of the walls, faces ascending. What names a surface in a run is its place here.
std::vector<Surface> surfaces(const Scene& scene);

/// L, the distance from the surface's plane or centre at which a particle of a radius touches it: the radius,
/// the sum or the difference of the two, rounded once.
double touching_distance(const Surface& surface, double radius);

/// "wall 0", "wall 1, face 2 (low y)", "wall 1, edge 6 (low x, low y)".
std::string surface_name(const Surface& surface);

/// The common velocity of all walls; nothing where there is none or they differ.
std::optional<Coordinates> velocity_of_walls(const Scene& scene);

}  // namespace tps
