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
        add_faces(scene, n, all);
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
