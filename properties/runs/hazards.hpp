// What a run met of the situations that generators aim at.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "properties/runs/simulator.hpp"

namespace tps::properties::runs {

/// A hazard, and how many of a thousand generated scenes meet it at least: about half of what they do;
/// tested.
struct HazardFloor {
  std::string name, meaning;
  int in_a_thousand;
};
const std::vector<HazardFloor>& hazard_floors();

/// The hazards that a scene and its run met.
std::set<std::string> hazards_met(const Scene& scene, const RunTrace& trace);

}  // namespace tps::properties::runs
