// Whole runs of a simulator, judged by the trace check.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "properties/conform/run_source.hpp"
#include "properties/conform/verdict.hpp"

namespace tps::properties::conform {

struct RunPlan {
  RunSource source;
  std::vector<std::string> features;                ///< of the scenes (random_scene.hpp)
  std::uint64_t scenes = 100, seed = 1, first = 0;  ///< so many from number `first` on
  std::function<bool()> stops = [] { return false; };
  std::function<void(const std::string& doing)> progress = [](const std::string&) {};
};

/// Adds rows: whole runs by their worst step, and what happened in them, event by event.
void ask_runs(const RunPlan& plan, Verdict& verdict);

}  // namespace tps::properties::conform
