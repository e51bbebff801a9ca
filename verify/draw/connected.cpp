#include "verify/draw/connected.hpp"

#include <algorithm>
#include <numeric>

namespace tps {

std::vector<int> cluster_of_particles(const Scene& scene, const std::vector<std::pair<int, int>>& tethers,
                                      const ClusterObservation& observed) {
  // Union by smallest member: a root is the smallest index of its component.
  std::vector<std::size_t> parent(scene.particles.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto root = [&](std::size_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  for (const auto& [i, j] : tethers) {
    const std::size_t a = root(static_cast<std::size_t>(i));
    const std::size_t b = root(static_cast<std::size_t>(j));
    parent[std::max(a, b)] = std::min(a, b);
  }

  std::vector<int> observed_members(parent.size(), 0);
  for (std::size_t i = 0; i < parent.size(); ++i) {
    if (scene.particles[i].species == observed.species) ++observed_members[root(i)];
  }
  std::vector<int> number(parent.size(), -1);
  int clusters = 0;
  for (std::size_t i = 0; i < parent.size(); ++i) {
    const std::size_t first = root(i);
    if (observed_members[first] < observed.at_least) continue;
    number[i] = first == i ? clusters++ : number[first];
  }
  return number;
}

}  // namespace tps
