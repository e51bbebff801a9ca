// Known answers of the responses, eqs. (3) to (7), and of groups.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string_view>

#include "verify/vectors/known_answer.hpp"

namespace tps::vectors {

/// The answer to a response operation or to `group`: enclosures of every component, `nearest`, the condition
/// number. Throws std::invalid_argument for another operation or an "in" that is not one.
Json response_answer(std::string_view op, const Json& in);

}  // namespace tps::vectors
