// The next event of a scene, and what it leaves: one step of the engine.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reference/engine/timing.hpp"
#include "reference/scene/scene.hpp"

namespace tps {

struct NextEvent {
  struct State {
    std::int32_t id;
    std::vector<double> position, velocity;
  };
  std::string kind = "none";         ///< as in traces; "none" where nothing ever happens
  std::optional<std::int32_t> i, j;  ///< ids of the particles concerned
  std::optional<double> dt;          ///< from the scene's start; absent for "none"
  std::string tether;                ///< "formed" or "broken", empty where neither
  std::vector<State> state;          ///< of all particles at the instant of the event, after it
};

/// Simulates one event, in double. The scene's duration does not matter, since it limits runs; but in a
/// periodic box, where something may always lie ahead, nothing is looked for behind it. Throws InputError
/// where pairs pass 10⁷ images in a box and nothing happens, or where a time leaves the range of double.
NextEvent next_event(const Scene& scene, const TimingChoice& timing = {});

}  // namespace tps
