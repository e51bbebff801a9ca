// From where a scene in space is looked at.
#pragma once

#include <array>

#include "reference/scene/scene.hpp"

namespace tps {

/// Axes renamed in turn, which turns space: what was axis `from` points to the viewer, the next one to the
/// right, the one after that upwards. From 2, the axis z, nothing changes.
inline Coordinates seen_from(std::size_t from, const Coordinates& x) {
  return {x[(from + 1) % 3], x[(from + 2) % 3], x[from]};
}

/// Whatever of a scene is drawn and has a place or a direction, but the particles: their places come apart.
inline Scene seen_from(std::size_t from, Scene scene) {
  for (Wall& wall : scene.walls) {
    for (Coordinates* each : {&wall.point, &wall.normal, &wall.high, &wall.velocity})
      *each = seen_from(from, *each);
  }
  if (scene.box) scene.box->edges = seen_from(from, scene.box->edges);
  return scene;
}

}  // namespace tps
