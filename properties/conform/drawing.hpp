// A case as a picture: who is where, what is right and what was found.
#pragma once

#include <string>

#include "properties/conform/mistakes.hpp"
#include "properties/conform/verdict.hpp"

namespace tps::properties::conform {

/// SVG, one picture or, of an order, two. A timing query: B's path relative to A, the circle of the limit, B
/// at both times. An impulse: the axis, the relative velocity, both impulses. Velocities after (3), (6), (7):
/// as vectors from one point. A group, a scene: the bodies from above. Empty where the case has no finite
/// numbers.
std::string drawing_of(const Example& example);

/// Bodies and their velocities after the group has parted.
std::string drawing_of_group(const Json& in, const Json& found, const Json& right);
/// Particles at the start, and who takes part in the right event and in the found one ("i", "j" of each).
std::string drawing_of_scene(const Json& scene, const Json& found, const Json& right);

}  // namespace tps::properties::conform
