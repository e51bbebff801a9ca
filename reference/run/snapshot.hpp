// Where everything is at one moment, in plain doubles: for pictures and statistics.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "reference/scene/scene.hpp"

namespace tps {

struct Snapshot {
  Scene scene;
  double t = 0;                                  ///< since the start, with drag, too
  std::vector<std::array<double, 3>> positions;  ///< of Scene::particles, in their order
  std::vector<Tether> tethers;                   ///< that exist at t, permanent ones not among them
};

/// The last full state of a trace or checkpoint whose time since the start is at most `at` (the last of all
/// by default), or the start of a scene file. Throws InputError.
Snapshot read_snapshot(const std::string& path, std::optional<double> at = std::nullopt);

}  // namespace tps
