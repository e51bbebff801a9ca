// An infinite mass read as a large finite one.
#pragma once

#include "properties/conform/expected.hpp"

namespace tps::properties::conform {

/// Whether the answer is the one to the same question with a power of ten, 10^3 to 10^18, for every "inf":
/// ten times nearer to it than to the right one, so that rounding is told from it. REQUIRES an answer that
/// is not right.
bool is_of_finite_mass(const KnownQuestion& known, const Json& out, const Expected& right);

}  // namespace tps::properties::conform
