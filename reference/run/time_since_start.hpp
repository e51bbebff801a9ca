// When a full state is, whatever clock it is on.
#pragma once

#include "reference/engine/state_data.hpp"
#include "reference/scene/scene.hpp"

namespace tps {

/// A number, or both parts of a time, of any length, to the nearest double: good enough for a picture.
double nearest(const Hex& text);
double nearest(const HexTime& time);

/// The time since the start of a state of the scene with that `now`, to the nearest double: with drag `now`
/// is a clock s, and what is meant is t (docs/effects.md). ∞ for a clock that never comes.
double time_since_start(const Scene& scene, const HexTime& now);

}  // namespace tps
