#include "verify/scenes/sheet.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "verify/scenes/thermal.hpp"

namespace tps {

Scene build_sheet(const SheetParams& params) {
  if (params.spacing > params.tether_distance) {
    throw std::invalid_argument(
        fmt::format("--spacing is {} and --tether-distance is {}; neighbours must start within their tethers",
                    params.spacing, params.tether_distance));
  }
  Scene scene;
  scene.title = "A membrane: a planar network tethered to its nearest neighbours";
  scene.duration = params.duration;
  scene.seed = params.seed;
  scene.species = {{.name = "node", .mass = 1, .radius = 0.5, .max_tethers = {}}};
  scene.pairs = {{.species_a = 0,
                  .species_b = 0,
                  .blocking = BlockingLaw{.distance = 1, .c_rebound = params.restitution},
                  .tethering = TetheringLaw{.distance = params.tether_distance,
                                            .c_retract = params.restitution,
                                            .c_revolve = params.restitution,
                                            .theta_revolve_deg = 45,
                                            .form = {.when = FormRule::When::never},
                                            .breaks = {.when = BreakRule::When::never}}}};
  if (params.grouped > 0) scene.grouping = Grouping{params.grouped};

  // Odd rows are shifted by half a spacing; rows are √3/2 of a spacing apart.
  const auto index = [&](int row, int column) { return row * params.columns + column; };
  const auto tether = [&](int i, int j) { scene.tethers.push_back({i, j}); };
  for (int row = 0; row < params.rows; ++row) {
    for (int column = 0; column < params.columns; ++column) {
      const double x = params.spacing * (column + 0.5 * (row % 2));
      const double y = params.spacing * (std::sqrt(3.0) / 2) * row;
      const int i = index(row, column);
      scene.particles.push_back({.id = i, .species = 0, .position = {x, y, 0}, .velocity = {}});
      if (column > 0) tether(i - 1, i);
      if (row == 0) continue;
      const int left = column - 1 + row % 2;  // the two neighbours in the row below are left and left + 1
      if (left >= 0) tether(index(row - 1, left), i);
      if (left + 1 < params.columns) tether(index(row - 1, left + 1), i);
    }
  }
  if (params.impact > 0) {
    scene.impulses = {{.at = params.impact_at,
                       .particle = index(params.rows / 2, params.columns / 2),
                       .impulse = {0, 0, -params.impact}}};
  }
  return with_thermal_velocities(scene, params.temperature);
}

SceneBuilder sheet_builder() {
  using P = SheetParams;
  return make_builder<P>(
      "sheet",
      "a membrane: a hexagonal network in space, tethered to nearest neighbours, and an impact on it",
      {{"rows", &P::rows, from_to(1, 1000), "rows of particles"},
       {"columns", &P::columns, from_to(1, 1000), "particles in a row"},
       {"spacing", &P::spacing, from_to(1, 2),
        "of neighbours, in diameters; 1: touching, tether-distance: taut"},
       {"tether-distance", &P::tether_distance, from_to(1.0001, 1.9), "outer limit, in diameters"},
       {"temperature", &P::temperature, from_to(0, 1e6), "kT of the start velocities; a particle has mass 1"},
       {"restitution", &P::restitution, from_to(0, 1), "c_rebound, c_retract and c_revolve"},
       {"impact", &P::impact, from_to(0, 1e6), "impulse on the particle in the middle, along -z; 0: none"},
       {"impact-at", &P::impact_at, from_to(0, 1e6), "time of the impact"},
       {"grouped", &P::grouped, from_to(0, 1e6), "dt_restitute of grouping; 0: no grouping"},
       {"duration", &P::duration, above(0), "time simulated"},
       {"seed", &P::seed, {}, "of the start velocities"}},
      &build_sheet);
}

}  // namespace tps
