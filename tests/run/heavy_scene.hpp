// A scene in which what a pair has responded to matters from event to event.
#pragma once

#include <limits>

#include "tests/run/traced_run.hpp"

namespace tps::testing {

/// A ball too heavy to notice the light ones that bounce between it and the walls: its velocity never
/// changes, so that what it has responded to is kept from event to event.
inline Scene heavy_scene() {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Scene scene = plain_scene();
  const int heavy = add_species(scene, "heavy", 1e20, .5);
  const int wall = add_species(scene, "wall", kInfinity, .5);
  block(scene, 0, heavy);
  block(scene, 0, wall);
  add_particle(scene, heavy, {0, 0, 0}, {.001, 0, 0});
  add_particle(scene, wall, {4, 0, 0});
  add_particle(scene, wall, {-4, 0, 0});
  add_particle(scene, wall, {0, 4, 0});
  add_particle(scene, 0, {0, 2, 0}, {0, 1.75, 0});
  add_particle(scene, 0, {2, 0, 0}, {1, 0, 0});
  add_particle(scene, 0, {-2, 0, 0}, {1.375, 0, 0});
  return scene;
}

}  // namespace tps::testing
