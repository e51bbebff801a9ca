// Known answers of next_event.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "verify/vectors/known_answer.hpp"

namespace tps::vectors {

/// The certified next event of {"scene": …}: kind, ids, dt, and every particle's position and velocity after
/// it. Of a scene, what these strata use is read: species with masses, pairs with blocking and tethering,
/// particles, tethers. Absent where a scene has no single answer. Throws std::invalid_argument for a scene
/// with anything else.
std::optional<Json> next_event_answer(const Json& in);

}  // namespace tps::vectors
