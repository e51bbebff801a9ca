// Enclosures in a case.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "verify/certified/certified_response.hpp"
#include "verify/vectors/known_answer.hpp"

namespace tps::vectors {

/// Adds one result to `out` and `nearest`: [lo, hi] of each component, and which double of it is the nearest.
void add_enclosures(Json& answer, const std::string& key, const certified::EnclosedVector& components);

}  // namespace tps::vectors
