// Known answers of the responses, eqs. (3) to (7), and of groups.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "verify/vectors/known_answer.hpp"

namespace tps::vectors {

/// The answer to a response operation or to `group`: enclosures of every component, `nearest`, the condition
/// number. Throws InputError for an "in" that the operation does not take,
/// std::invalid_argument for another operation or a question without a single answer.
Json response_answer(Op op, const Json& in);

}  // namespace tps::vectors
