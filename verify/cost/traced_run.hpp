// A run with the events that its trace tells, for comparing runs event by event.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "reference/run/run.hpp"

namespace tps::cost {

struct TracedRun {
  RunSummary summary;
  std::vector<std::string> events;  ///< kind and pair of each, as the trace spells them
};

/// Runs a scene and reads its trace. Takes scalar, timing, until and max_events from the options. REQUIRES
/// can_be_timed(). Throws as run_scene() does, and where the user interrupts.
TracedRun traced_run(const Scene& scene, const RunOptions& options);

/// The same without a trace, which costs more time than the events: for its seconds.
RunSummary timed_run(const Scene& scene, const RunOptions& options);

/// The events but the restitutions: the collisions that a run without grouping has, too.
std::vector<std::string> collisions_of(const TracedRun& run);

/// The number of events, in order, that two runs have in common; absent where neither has another.
std::optional<std::uint64_t> horizon(const std::vector<std::string>& events,
                                     const std::vector<std::string>& truth);

}  // namespace tps::cost
