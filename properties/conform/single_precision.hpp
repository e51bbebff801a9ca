// Answers of which some step was in single precision.
#pragma once

#include "properties/conform/expected.hpp"

namespace tps::properties::conform {

/// Whether the question, asked in floats, has this answer: with everything in float, to a few units of it
/// times the condition number, where the answer's numbers are floats themselves; or in double with its
/// numbers, or the differences of them that eqs. (2) to (5) begin with, rounded to float, a hundred times
/// nearer to that than to the right answer. Law: (1) an answer nearer to the right one than 2^-30 of it, in
/// more bits than a float has, is none of these. REQUIRES an answer that is not right.
bool is_single_precision(const KnownQuestion& known, const Json& out, const Expected& right);

}  // namespace tps::properties::conform
