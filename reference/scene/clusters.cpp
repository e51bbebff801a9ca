#include "reference/scene/clusters.hpp"

#include <algorithm>
#include <map>
#include <numeric>

namespace tps {

std::vector<std::vector<int>> clusters_of(const Scene& scene, const std::vector<Tether>& tethers,
                                          const ClusterObservation& observed) {
  std::vector<int> parent(scene.particles.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto parent_of = [&](int i) -> int& { return parent[static_cast<std::size_t>(i)]; };
  const auto root_of = [&](int i) {
    while (parent_of(i) != i) i = parent_of(i) = parent_of(parent_of(i));
    return i;
  };
  for (const Tether& tether : tethers) parent_of(root_of(tether.j)) = root_of(tether.i);
  std::map<int, std::vector<int>> components;
  for (std::size_t i = 0; i < scene.particles.size(); ++i) {
    components[root_of(static_cast<int>(i))].push_back(static_cast<int>(i));
  }
  const auto size_of = [&](const std::vector<int>& c) { return count_species(scene, c, observed.species); };
  std::vector<std::vector<int>> clusters;
  for (const auto& [root, component] : components) {
    if (size_of(component) >= observed.at_least) clusters.push_back(component);
  }
  std::sort(clusters.begin(), clusters.end(), [&](const std::vector<int>& a, const std::vector<int>& b) {
    const int size_a = size_of(a);
    const int size_b = size_of(b);
    return size_a != size_b ? size_a > size_b : a.front() < b.front();
  });
  return clusters;
}

int count_species(const Scene& scene, const std::vector<int>& particles, int species) {
  return static_cast<int>(std::count_if(particles.begin(), particles.end(), [&](int i) {
    return scene.particles[static_cast<std::size_t>(i)].species == species;
  }));
}

}  // namespace tps
