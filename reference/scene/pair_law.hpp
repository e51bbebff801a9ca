// The law that two species follow.
#pragma once

#include <algorithm>
#include <vector>

#include "reference/scene/scene.hpp"

namespace tps {

/// Of a and b in either order; null where they do not interact.
inline const PairLaw* pair_law(const std::vector<PairLaw>& laws, int a, int b) {
  const auto found = std::find_if(laws.begin(), laws.end(), [&](const PairLaw& law) {
    return law.species_a == std::min(a, b) && law.species_b == std::max(a, b);
  });
  return found == laws.end() ? nullptr : &*found;
}

}  // namespace tps
