// What a run met of the situations that generators aim at.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "properties/runs/simulator.hpp"

namespace tps::properties {

/// Names of all hazards, each with the least part of generated scenes that meet it, in percent; tested.
struct HazardFloor {
  std::string name, meaning;
  int percent;
};
const std::vector<HazardFloor>& hazard_floors();

/// The hazards that a scene and its run met.
std::set<std::string> hazards_met(const Scene& scene, const RunTrace& trace);

}  // namespace tps::properties
