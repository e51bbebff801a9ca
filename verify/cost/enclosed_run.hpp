// A run of a whole set of starts at once: the events that every start of the set has, in one order
// (docs/accuracy-cost.md, "What is proven").
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "reference/scene/scene.hpp"

namespace tps::cost {

/// Which starts a run holds for.
enum class Starts {
  stored,   ///< the scene as it is stored, alone
  rounding  ///< all whose positions and velocities, rounded to double, are the stored ones; laws and masses
            ///< as stored
};

struct EnclosedRunOptions {
  Starts starts = Starts::rounding;
  long bits = 256;  ///< of the centres
  std::uint64_t max_events = 3000;
};

/// What every start of the set has in common.
struct EnclosedRun {
  std::vector<std::string> events;  ///< kind and pair of each, spelled as in traced_run.hpp
  /// Why there is no further one: "events", max_events are there; "end", no start has another before its
  /// duration ends; "order", two may come in either order; "verdict", whether one comes, or which response,
  /// depends on the start; "start", a pair may be at a limit, or beyond, from the beginning.
  std::string ends_by;
};

/// Why a scene cannot be run so; empty where it can. Rebounds, and retractions and revolutions of tethers
/// that neither form nor break, are known; a few hundred particles.
std::string why_not_enclosed(const Scene& scene);

/// Real arithmetic on sets of numbers (affine_form.hpp): an event is told only where it is proven for every
/// start. REQUIRES why_not_enclosed() empty.
EnclosedRun enclosed_run(const Scene& scene, const EnclosedRunOptions& options);

}  // namespace tps::cost
