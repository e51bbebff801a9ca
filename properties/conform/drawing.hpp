// A case as a picture: the pair as it moves relative to A, its limit, what is right and what was found.
#pragma once

#include <string>

#include "properties/conform/verdict.hpp"

namespace tps::properties::conform {

/// SVG of a timing query (B's path, the circle of the limit, B at both times) or of an impulse (the axis, the
/// relative velocity, both impulses), in the plane of r and v; empty for any other case.
std::string drawing_of(const Example& example);

}  // namespace tps::properties::conform
