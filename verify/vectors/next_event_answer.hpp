// Known answers of next_event.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "verify/vectors/known_answer.hpp"

namespace tps::vectors {

/// The certified next event of {"scene": …}: kind, ids, dt, and every particle's position and velocity after
/// it. Absent where a scene has no single answer: two events at one time, or a kind at its boundary. Throws
/// InputError for what is no scene, std::invalid_argument for one with effects that known answers do not
/// have.
std::optional<Json> next_event_answer(const Json& in);

}  // namespace tps::vectors
