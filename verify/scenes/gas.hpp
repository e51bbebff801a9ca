// A hard-sphere gas in a spherical membrane.
#pragma once

#include <cstdint>

#include "verify/scenes/builder.hpp"

namespace tps {

/// Spheres of diameter 1 and mass 1.
struct GasParams {
  int particles = 256;
  double density = 0.3;
  double temperature = 1;
  double restitution = 1;
  double grouped = 0;
  int periodic = 0;  ///< 1: in a periodic cube instead of the membrane
  int walls = 0;     ///< 1: in a cube of walls instead of the membrane
  double drag = 0;   ///< γ; 0: none
  double duration = 10;
  std::uint64_t seed = 1;
};

/// The gas in a membrane from which a scene with the same six parameters is made.
template <typename Params>
GasParams gas_of(const Params& params) {
  GasParams gas;
  gas.particles = params.particles;
  gas.density = params.density;
  gas.temperature = params.temperature;
  gas.restitution = params.restitution;
  gas.duration = params.duration;
  gas.seed = params.seed;
  return gas;
}

/// Spheres on a face-centred cubic lattice that fills the membrane evenly, with Maxwell velocities without
/// total momentum; the lattice melts within a few mean free times. `density` is the number of spheres over
/// the volume of the membrane's ball, whose radius is the smallest multiple of 1/1024 with at most that
/// density. The membrane is a particle of infinite mass and a permanent tether, elastic. Its retraction is
/// specular while a sphere meets it at more than theta = 0.01° from the tangent. Throws std::invalid_argument
/// when so many spheres do not fit at that density, or drag is asked for beside grouping.
Scene build_gas(const GasParams& params);

/// The same in a cube, [0, edge] along each axis, whose edge is the smallest multiple of 1/1024 with at most
/// that density. It is periodic, or its faces are walls, which touch spheres at half a unit. Throws
/// std::invalid_argument where it is asked to be both.
Scene build_gas_in_cube(const GasParams& params);
SceneBuilder gas_builder();

}  // namespace tps
