// Small scenes in which every rule of a trace has something to do.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "reference/run/run.hpp"
#include "reference/scene/scene.hpp"

namespace tps::mutation {

struct NamedScene {
  std::string name;
  Scene scene;
  std::uint64_t events;       ///< that its trace is cut to
  bool stands_still = false;  ///< long and monotonous: only its end is of interest
};

/// The shipped scenes and those made for the check, by name.
std::vector<std::string> scene_names();
NamedScene scene_named(const std::string& name);
/// What NamedScene says, without reading the scene.
bool stands_still(const std::string& name);

/// A gas of few particles for long runs.
Scene long_gas();

/// The bytes of a scene's trace.
std::string trace_bytes(const Scene& scene, const std::string& scalar, Timing timing, std::uint64_t events,
                        std::uint64_t state_every = 75);

}  // namespace tps::mutation
