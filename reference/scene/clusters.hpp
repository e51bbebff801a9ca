// Clusters: connected components of tethers that hold enough particles of one species.
#pragma once

#include <vector>

#include "reference/scene/scene.hpp"

namespace tps {

/// The clusters of a graph of tethers (permanent ones do not count), the largest by the observed species
/// first, of equally large ones the one with the smallest particle; each ascending.
std::vector<std::vector<int>> clusters_of(const Scene& scene, const std::vector<Tether>& tethers,
                                          const ClusterObservation& observed);

/// How many of some particles are of a species.
int count_species(const Scene& scene, const std::vector<int>& particles, int species);

}  // namespace tps
