// What the reference answers to a question that was changed on the way to it.
#pragma once

#include <string>

#include "properties/conform/expected.hpp"
#include "properties/conform/mistakes.hpp"

namespace tps::properties::conform {

/// The numbers of an answer that are to be as these, in one vector; empty where they are not there.
Vec numbers_as(const Expected& right, const Json& out);
/// The right ones.
Vec nearest_numbers(const Expected& right);

/// The answer of the equations in "float" or "double"; empty where they have none.
Vec reference_answer(const std::string& scalar, Op op, const Json& in, const Expected& right);

}  // namespace tps::properties::conform
