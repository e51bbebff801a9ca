#include "reference/scene/surfaces.hpp"

#include <algorithm>

namespace tps {
namespace {

void add_faces(const Scene& scene, std::size_t n, std::vector<Surface>& all) {
  const Wall& wall = scene.walls[n];
  for (int face = 0; face < 2 * scene.dimension; ++face) {
    Coordinates normal{};
    normal[static_cast<std::size_t>(face / 2)] = face % 2 == 0 ? 1 : -1;
    all.push_back({Surface::Kind::plane, n, face, face % 2 == 0 ? wall.point : wall.high, normal, 0,
                   wall.c_rebound, wall.velocity});
  }
}

using Side = BoxRegion::Side;

/// Adds the parts that are nearest where the given axes lie beyond the ends of the box, low before high.
void add_parts(const Scene& scene, std::size_t n, const std::vector<std::size_t>& axes, int& face,
               std::vector<Surface>& all) {
  const Wall& wall = scene.walls[n];
  for (unsigned ends = 0; ends < 1U << axes.size(); ++ends) {
    BoxRegion region{{Side::between, Side::between, Side::between}, wall.point, wall.high};
    Surface part{Surface::Kind::outside, n, face++, wall.point, {}, 0, wall.c_rebound, wall.velocity};
    for (std::size_t m = 0; m < axes.size(); ++m) {
      const std::size_t k = axes[m];
      const bool is_high = (ends >> (axes.size() - 1 - m) & 1U) != 0;
      region.sides[k] = is_high ? Side::above : Side::below;
      part.point[k] = is_high ? wall.high[k] : wall.point[k];
      if (axes.size() > 1) continue;
      part.kind = Surface::Kind::plane;
      part.normal[k] = is_high ? 1 : -1;
    }
    part.region = region;
    all.push_back(part);
  }
}

/// Faces, edges, corners.
void add_outside(const Scene& scene, std::size_t n, std::vector<Surface>& all) {
  const auto dimension = static_cast<std::size_t>(scene.dimension);
  int face = 0;
  for (std::size_t a = 0; a < dimension; ++a) add_parts(scene, n, {a}, face, all);
  for (std::size_t a = 0; a < dimension; ++a) {
    for (std::size_t b = a + 1; b < dimension; ++b) add_parts(scene, n, {a, b}, face, all);
  }
  if (dimension == 3) add_parts(scene, n, {0, 1, 2}, face, all);
}

/// "edge 6 (low x, high y)"; in the plane, where a box has no ends along z, two axes make a corner.
std::string part_name(const Surface& surface) {
  const BoxRegion& region = *surface.region;
  std::string ends;
  int axes = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    if (!region.measures(k)) continue;
    ends += (axes++ == 0 ? "" : ", ") + std::string(region.sides[k] == Side::below ? "low " : "high ") +
            std::string(1, "xyz"[k]);
  }
  const bool is_planar = !(region.low[2] < region.high[2]);
  const char* what = axes == 1 ? "face " : axes == 2 && !is_planar ? "edge " : "corner ";
  return what + std::to_string(*surface.face) + " (" + ends + ")";
}

}  // namespace

std::vector<Surface> surfaces(const Scene& scene) {
  std::vector<Surface> all;
  for (std::size_t n = 0; n < scene.walls.size(); ++n) {
    const Wall& wall = scene.walls[n];
    switch (wall.shape) {
      case Wall::Shape::plane:
        all.push_back({Surface::Kind::plane, n, std::nullopt, wall.point, wall.normal, 0, wall.c_rebound,
                       wall.velocity});
        break;
      case Wall::Shape::sphere:
        all.push_back({wall.inside ? Surface::Kind::inside : Surface::Kind::outside,
                       n,
                       std::nullopt,
                       wall.point,
                       {},
                       wall.radius,
                       wall.c_rebound,
                       wall.velocity});
        break;
      case Wall::Shape::box:
        if (wall.inside)
          add_faces(scene, n, all);
        else
          add_outside(scene, n, all);
        break;
    }
  }
  return all;
}

double touching_distance(const Surface& surface, double radius) {
  if (surface.kind == Surface::Kind::plane) return radius;
  return surface.kind == Surface::Kind::inside ? surface.radius - radius : surface.radius + radius;
}

std::string surface_name(const Surface& surface) {
  std::string name = "wall " + std::to_string(surface.wall);
  if (surface.region) return name + ", " + part_name(surface);
  if (surface.face) {
    name += ", face " + std::to_string(*surface.face) + (*surface.face % 2 == 0 ? " (low " : " (high ");
    name += std::string(1, "xyz"[*surface.face / 2]) + ")";
  }
  return name;
}

std::optional<Coordinates> velocity_of_walls(const Scene& scene) {
  if (scene.walls.empty()) return std::nullopt;
  const auto differs = [&](const Wall& wall) { return wall.velocity != scene.walls.front().velocity; };
  if (std::any_of(scene.walls.begin(), scene.walls.end(), differs)) return std::nullopt;
  return scene.walls.front().velocity;
}

}  // namespace tps
