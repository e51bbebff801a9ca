// A scene as the certified next event takes it: bodies, and the limits at which pairs of them can meet.
#pragma once

#include <optional>
#include <string>

#include "reference/scene/scene.hpp"
#include "verify/certified/certified_next_event.hpp"

namespace tps::certified {

/// What of the scene keeps its next event from being certified: the name of an effect that it calls for and
/// that is none of the paper's three (rebound, tethering, grouping), or a rule with a probability. Absent
/// where nothing does.
std::optional<std::string> not_certified(const Scene& scene);

/// The particles in the order of ids, and every limit of theirs, blocking before tethering of one pair. Takes
/// time and memory quadratic in the particles. REQUIRES !not_certified(scene).
NextEventInput next_event_input(const Scene& scene);

}  // namespace tps::certified
