// Bodies in a row that run into each other one after the other.
#pragma once

#include "properties/case.hpp"
#include "properties/format.hpp"

namespace tps::properties {

/// Sets m, u, v of 2 to 5 bodies on a line whose velocities along it fall from one to the next, and
/// collisions i, j, c of neighbours in any order: each pair approaches whatever was loaded before, since a
/// group's velocity is between those of its members. Hazards: "chain", "wall" (the first body is infinite and
/// at rest), "pairs" (two pairs load apart before they meet), "perpendicular" (some neighbours do not move
/// along the line).
void put_group(Case& c, const Format& format);

}  // namespace tps::properties
