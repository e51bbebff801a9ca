// Contacts that neither approach nor recede but for rounding.
#pragma once

#include "properties/runs/scenes.hpp"

namespace tps::properties::runs {

/// Up to 32 pairs that touch and move across, each of a species of its own, so that none knows of the others.
/// Whether r·v and v·û come out negative, zero or positive is rounding: in one of some hundred pairs they
/// disagree. `dimension` is 2 or 3; 0: either.
rc::Gen<SmallScene> touching_pairs(int dimension);

}  // namespace tps::properties::runs
