#include "verify/scenes/gas.hpp"

#include <fmt/format.h>

#include <limits>
#include <numbers>
#include <stdexcept>

#include "verify/scenes/thermal.hpp"

namespace tps {
namespace {

double square(const Coordinates& u) {
  return u[0] * u[0] + u[1] * u[1] + u[2] * u[2];
}

/// Where the origin lies in the lattice: in a hole, between four neighbours (shift 1/2), or at a point (0).
constexpr double kHole = 0.5, kPoint = 0;

/// Points of the face-centred cubic lattice with the given distance of neighbours, no farther than `reach`
/// from the origin.
std::vector<Coordinates> lattice_in_ball(double neighbours, double reach, double shift) {
  const double step = neighbours / std::numbers::sqrt2;  // half the cube's edge: points have even i + j + k
  const int most = static_cast<int>(reach / step) + 2;
  std::vector<Coordinates> points;
  for (int i = -most; i <= most; ++i) {
    for (int j = -most; j <= most; ++j) {
      for (int k = -most; k <= most; ++k) {
        if ((i + j + k) % 2 != 0) continue;
        const Coordinates point{(i + shift) * step, (j + shift) * step, (k + shift) * step};
        if (square(point) <= reach * reach) points.push_back(point);
      }
    }
  }
  return points;
}

/// The radius of the membrane, by comparisons only: a cube root of the C library may differ between
/// platforms.
double membrane_radius(int particles, double density) {
  const double cubed = particles / (density * (4 * std::numbers::pi / 3));
  double radius = 0;
  for (double step = 0x1p20; step >= 0x1p-10; step /= 2) {
    if ((radius + step) * (radius + step) * (radius + step) < cubed) radius += step;
  }
  return radius + 0x1p-10;
}

Scene build_gas_in_membrane(const GasParams& params) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const double radius = membrane_radius(params.particles, params.density);
  const auto needed = static_cast<std::size_t>(params.particles);

  // The widest lattice, in steps of 1 %, that has enough points; the closest one has neighbours just apart.
  // Around a hole at first; a few spheres, one to begin with, may fit around a point only.
  std::vector<Coordinates> points;
  for (const double shift : {kHole, kPoint}) {
    for (int percent = 400; percent > 100 && points.size() < needed; --percent) {
      points = lattice_in_ball(percent / 100.0, radius - 0.5 - 0x1p-20, shift);
    }
  }
  if (points.size() < needed) {
    throw std::invalid_argument(fmt::format(
        "--particles {} and --density {}: only {} spheres fit into the membrane of radius {}; lower the "
        "density or take more particles",
        params.particles, params.density, points.size(), radius));
  }

  Scene scene;
  scene.title = "A hard-sphere gas in a spherical membrane";
  scene.duration = params.duration;
  scene.seed = params.seed;
  scene.species = {{.name = "membrane", .mass = kInfinity, .radius = radius, .max_tethers = {}},
                   {.name = "sphere", .mass = 1, .radius = 0.5, .max_tethers = {}}};
  scene.pairs = {{.species_a = 0,
                  .species_b = 1,
                  .blocking = {},
                  .tethering = TetheringLaw{.distance = radius - 0.5,
                                            .c_retract = 1,
                                            .c_revolve = 1,
                                            .theta_revolve_deg = 0.01,
                                            .form = {.when = FormRule::When::permanent},
                                            .breaks = {.when = BreakRule::When::never}}},
                 {.species_a = 1,
                  .species_b = 1,
                  .blocking = BlockingLaw{.distance = 1, .c_rebound = params.restitution},
                  .tethering = {}}};
  if (params.grouped > 0) scene.grouping = Grouping{params.grouped};
  scene.particles = {{.id = 0, .species = 0, .position = {}, .velocity = {}}};
  // Evenly spread over the points, when there are more of them than spheres.
  for (std::size_t i = 0; i < needed; ++i) {
    scene.particles.push_back({.id = static_cast<std::int32_t>(i) + 1,
                               .species = 1,
                               .position = points[i * points.size() / needed],
                               .velocity = {}});
  }
  return with_thermal_velocities(scene, params.temperature);
}

}  // namespace

Scene build_gas(const GasParams& params) {
  if (params.drag > 0 && params.grouped > 0)
    throw std::invalid_argument(
        "--drag and --grouped: dt_restitute is a time, and where it ends on the clock of drag depends on "
        "when it "
        "begins; choose one");
  const bool in_cube = params.walls != 0 || params.periodic != 0;
  Scene scene = in_cube ? build_gas_in_cube(params) : build_gas_in_membrane(params);
  if (params.drag > 0) scene.drag = Drag{params.drag};
  return scene;
}

SceneBuilder gas_builder() {
  using P = GasParams;
  return make_builder<P>(
      "gas", "hard spheres in a spherical membrane at a given density",
      {{"particles", &P::particles, from_to(1, 1000000), "spheres"},
       {"density", &P::density, from_to(1e-6, 1),
        "spheres over the volume of the membrane; times π/6: filled part"},
       {"temperature", &P::temperature, from_to(0, 1e6), "kT of the start velocities; a sphere has mass 1"},
       {"restitution", &P::restitution, from_to(0, 1), "c_rebound of two spheres"},
       {"grouped", &P::grouped, from_to(0, 1e6),
        "dt_restitute of grouping, well below a mean free time; 0: no grouping"},
       {"periodic", &P::periodic, from_to(0, 1), "1: in a periodic cube instead of the membrane"},
       {"walls", &P::walls, from_to(0, 1), "1: in a cube of walls instead of the membrane"},
       {"drag", &P::drag, from_to(0, 1e6), "γ of a drag on all; 0: none"},
       {"duration", &P::duration, above(0), "time simulated"},
       {"seed", &P::seed, {}, "of the start velocities"}},
      &build_gas);
}

}  // namespace tps
