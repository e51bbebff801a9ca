#include <fmt/format.h>

#include <numbers>
#include <stdexcept>

#include "reference/scene/check_box.hpp"
#include "verify/scenes/gas.hpp"
#include "verify/scenes/thermal.hpp"

namespace tps {
namespace {

/// The edge of the cube, by comparisons only (gas.cpp).
double cube_edge(int particles, double density) {
  double edge = 0;
  for (double step = 0x1p20; step >= 0x1p-10; step /= 2) {
    const double longer = edge + step;
    if (longer * longer * longer * density < particles) edge = longer;
  }
  return edge + 0x1p-10;
}

/// The face-centred cubic lattice of `cells`³ cubes of the given edge from a corner on: four points each.
std::vector<Coordinates> lattice(int cells, double edge, double corner) {
  static constexpr Coordinates basis[] = {{0, 0, 0}, {.5, .5, 0}, {.5, 0, .5}, {0, .5, .5}};
  std::vector<Coordinates> points;
  for (int i = 0; i < cells; ++i) {
    for (int j = 0; j < cells; ++j) {
      for (int k = 0; k < cells; ++k) {
        for (const Coordinates& b : basis)
          points.push_back(
              {corner + (i + b[0]) * edge, corner + (j + b[1]) * edge, corner + (k + b[2]) * edge});
      }
    }
  }
  return points;
}

}  // namespace

Scene build_gas_in_cube(const GasParams& params) {
  if (params.walls != 0 && params.periodic != 0)
    throw std::invalid_argument(
        "--walls 1 and --periodic 1: the cube has either walls or periodic edges; give one");
  const bool periodic = params.periodic != 0;
  constexpr double kRadius = 0.5;
  const double edge = cube_edge(params.particles, params.density);
  if (periodic && !is_wide_enough(edge, 2 * kRadius)) {
    throw std::invalid_argument(fmt::format(
        "--periodic 1, --particles {} and --density {}: in a cube of edge {} a sphere would meet two "
        "images of another at once; take more particles or lower the density",
        params.particles, params.density, edge));
  }
  int cells = 1;
  while (4 * cells * cells * cells < params.particles) ++cells;
  // Between walls the first and last layers of the lattice touch them.
  const double cube = periodic ? edge / cells : (edge - 2 * kRadius) / (cells - 0.5);
  if (!(cube > std::numbers::sqrt2 * 2 * kRadius)) {
    throw std::invalid_argument(fmt::format(
        "--particles {} and --density {}: the spheres do not fit into a cube of edge {}; lower the "
        "density or take more particles",
        params.particles, params.density, edge));
  }
  const std::vector<Coordinates> points = lattice(cells, cube, periodic ? 0 : kRadius);
  Scene scene;
  scene.title = periodic ? "A hard-sphere gas in a periodic box" : "A hard-sphere gas between walls";
  scene.duration = params.duration;
  scene.seed = params.seed;
  scene.species = {{.name = "sphere", .mass = 1, .radius = kRadius, .max_tethers = {}}};
  scene.pairs = {{.species_a = 0,
                  .species_b = 0,
                  .blocking = BlockingLaw{.distance = 2 * kRadius, .c_rebound = params.restitution},
                  .tethering = {}}};
  if (params.grouped > 0) scene.grouping = Grouping{params.grouped};
  if (periodic) {
    scene.box = PeriodicEdges{{edge, edge, edge}};
  } else {
    Wall walls;
    walls.shape = Wall::Shape::box;
    walls.high = {edge, edge, edge};
    scene.walls = {walls};
  }
  const auto needed = static_cast<std::size_t>(params.particles);
  for (std::size_t i = 0; i < needed; ++i) {
    scene.particles.push_back({.id = static_cast<std::int32_t>(i),
                               .species = 0,
                               .position = points[i * points.size() / needed],
                               .velocity = {}});
  }
  return with_thermal_velocities(scene, params.temperature);
}

}  // namespace tps
