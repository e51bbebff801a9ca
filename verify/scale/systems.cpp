#include "verify/scale/systems.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "verify/scenes/gas.hpp"
#include "verify/scenes/sheet.hpp"
#include "verify/scenes/terminal.hpp"
#include "verify/scenes/thermal.hpp"

namespace tps::scale {
namespace {

constexpr double kLong = 1e9;  ///< nothing ends because its time is up

/// Spheres over volume at which spheres of diameter 1 fill φ of it.
double density(double filled) {
  return filled * 6 / std::numbers::pi;
}

}  // namespace

Scene hard_spheres(int particles, double filled) {
  return build_gas({.particles = particles, .density = density(filled), .duration = kLong});
}

Scene periodic_spheres(int particles, double filled) {
  return build_gas_in_cube(
      {.particles = particles, .density = density(filled), .periodic = 1, .duration = kLong});
}

Scene chains(int particles, int beads) {
  constexpr double kSpacing = 1.2;
  const double rows = std::cbrt(particles / (4 * std::numbers::pi / 3));
  const double reach = rows * kSpacing + kSpacing;
  Scene scene;
  scene.title = "Chains in a spherical membrane";
  scene.duration = kLong;
  scene.species = {{.name = "membrane",
                    .mass = std::numeric_limits<double>::infinity(),
                    .radius = reach + 0.5,
                    .max_tethers = {}},
                   {.name = "bead", .mass = 1, .radius = 0.5, .max_tethers = {}}};
  const auto tether = [](double distance, FormRule::When form) {
    return TetheringLaw{.distance = distance,
                        .theta_revolve_deg = 0.01,
                        .form = {.when = form},
                        .breaks = {.when = BreakRule::When::never}};
  };
  scene.pairs = {
      {.species_a = 0, .species_b = 1, .blocking = {}, .tethering = tether(reach, FormRule::When::permanent)},
      {.species_a = 1,
       .species_b = 1,
       .blocking = BlockingLaw{.distance = 1, .c_rebound = 1},
       .tethering = tether(1.5, FormRule::When::never)}};
  scene.particles = {{.id = 0, .species = 0, .position = {}, .velocity = {}}};
  // Along the rows of a cubic lattice, to and fro, so that a chain turns from row to row.
  const int most = static_cast<int>(rows) + 1;
  int linked = 0;
  Coordinates last{};
  for (int z = -most; z <= most; ++z) {
    for (int row = -most; row <= most; ++row) {
      const int y = z % 2 == 0 ? row : -row;
      for (int column = -most; column <= most; ++column) {
        const int x = (y + z) % 2 == 0 ? column : -column;
        if (x * x + y * y + z * z >= rows * rows) continue;
        const int id = static_cast<int>(scene.particles.size());
        const Coordinates place{x * kSpacing, y * kSpacing, z * kSpacing};
        const double apart =
            std::abs(place[0] - last[0]) + std::abs(place[1] - last[1]) + std::abs(place[2] - last[2]);
        const bool goes_on = linked > 0 && linked < beads && apart < 1.01 * kSpacing;
        if (goes_on) scene.tethers.push_back({id - 1, id});
        linked = goes_on ? linked + 1 : 1;
        last = place;
        scene.particles.push_back({.id = id, .species = 1, .position = place, .velocity = {}});
      }
    }
  }
  return with_thermal_velocities(scene, 1);
}

Scene terminal(int vesicles, bool grouped) {
  // As full as the scene of 48 vesicles in a membrane of radius 22.
  const double radius = 22 * std::cbrt(vesicles / 48.0);
  return build_terminal({.vesicles = vesicles,
                         .pairs = 2 * vesicles,
                         .membrane_radius = radius,
                         .impacts = 0,
                         .grouped = grouped ? 1e-4 : 0,
                         .duration = kLong});
}

Scene sheet(int particles, bool grouped) {
  const int side = static_cast<int>(std::sqrt(particles));
  return build_sheet({.rows = side,
                      .columns = side,
                      .temperature = 1,
                      .restitution = 1,
                      .impact = 0,
                      .grouped = grouped ? 1e-4 : 0,
                      .duration = kLong});
}

}  // namespace tps::scale
