// A deformable membrane: a planar network.
#pragma once

#include <cstdint>

#include "verify/scenes/builder.hpp"

namespace tps {

/// Particles of diameter 1 and mass 1; lengths are in diameters.
struct SheetParams {
  int rows = 8;
  int columns = 8;
  double spacing = 1.2;
  double tether_distance = 1.4;
  double temperature = 0.01;
  double restitution = 0.9;
  double impact = 5;
  double impact_at = 1;
  double grouped = 0.001;
  double duration = 10;
  std::uint64_t seed = 1;
};

/// A hexagonal network in the plane z = 0, in three dimensions, each particle tethered to its nearest
/// neighbours (six inside). `spacing` 1 makes neighbours touch, `tether_distance` makes every tether taut;
/// either start is a contact within rounding. The impact is an impulse along -z on the particle in the
/// middle. Throws std::invalid_argument when spacing exceeds the tether distance.
Scene build_sheet(const SheetParams& params);
SceneBuilder sheet_builder();

}  // namespace tps
