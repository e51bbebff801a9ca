// One scene, run and checked in one scalar and timing.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "properties/campaign/nasty_scenes.hpp"

namespace tps::properties::campaign {

struct Mode {
  std::string scalar, timing;
  int once_in = 1;  ///< of so many scenes; the wide scalars are slow
};
/// All that the engine runs: float, double and long-double, and a few scenes of mp50.
const std::vector<Mode>& all_modes();

enum class Fate {
  passed,      ///< nothing violated; under certified timing nothing undecided
  undecided,   ///< something left open, which is allowed for stable and printed timing
  left_range,  ///< refused in this scalar, or ended because it left its range
  alarm,       ///< a rule is violated, or the run did something that no run may
};

struct Trial {
  Fate fate = Fate::passed;
  std::uint64_t events = 0, undecided = 0;
  bool inconclusive = false;
  std::string message;  ///< of an alarm: rule and first finding
};

/// Runs the scene for at most `max_events` and judges the trace. Never throws: what a run throws is an alarm,
/// unless it refuses the scene.
Trial try_scene(const NastyScene& nasty, const Mode& mode, std::uint64_t max_events);

/// How often try_scene's runs write a full state.
constexpr std::uint64_t kStateEvery = 13;

}  // namespace tps::properties::campaign
