// Groups as the paper has them, in 150 digits: what `group` is compared with. Heavy header: only sources of
// laws include it.
#pragma once

#include "properties/interview.hpp"

namespace tps::properties {

/// Loads the inner collisions in order by (4), (6) and (7), then parts the nodes, newest first, by (3).
/// Infinite masses ground what they touch (semantics §4). REQUIRES collisions between different bodies, not
/// both infinite.
GroupVelocities nested_loads(const GroupCase& group);

}  // namespace tps::properties
