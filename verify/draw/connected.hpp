// Connected components of tethers, for the tints of a picture.
#pragma once

#include <utility>
#include <vector>

#include "reference/scene/scene.hpp"

namespace tps {

/// For each particle the number of its cluster, 0, 1, … by smallest member, or -1 when it is in none:
/// components of `tethers` with at least `observed.at_least` particles of `observed.species`.
std::vector<int> cluster_of_particles(const Scene& scene, const std::vector<std::pair<int, int>>& tethers,
                                      const ClusterObservation& observed);

}  // namespace tps
