// Clusters: connected components of tethers, and how a cluster moves.
#pragma once

#include <algorithm>
#include <functional>
#include <map>
#include <numeric>
#include <string>
#include <vector>

#include "reference/engine/world.hpp"
#include "reference/run/run.hpp"

namespace tps {

/// The components of the tether graph (permanent tethers do not count) that hold enough of the observed
/// species, the largest first; each ascending. Of equally large ones the one with the smallest particle is
/// first.
template <typename Scalar, int D>
std::vector<std::vector<int>> clusters_of(const World<Scalar, D>& world, const ClusterObservation& observed) {
  std::vector<int> parent(world.particles.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root_of = [&](int i) {
    while (parent[world.index(i)] != i)
      i = parent[world.index(i)] = parent[world.index(parent[world.index(i)])];
    return i;
  };
  for (int i = 0; i < world.size(); ++i) {
    for (const int j : world.tethers.of(i)) parent[world.index(root_of(j))] = root_of(i);
  }
  std::map<int, std::vector<int>> components;
  for (int i = 0; i < world.size(); ++i) components[root_of(i)].push_back(i);
  const auto size_of = [&](const std::vector<int>& component) {
    return std::count_if(component.begin(), component.end(),
                         [&](int i) { return world.species(i) == observed.species; });
  };
  std::vector<std::vector<int>> clusters;
  for (auto& [root, component] : components) {
    if (size_of(component) >= observed.at_least) clusters.push_back(std::move(component));
  }
  std::sort(clusters.begin(), clusters.end(), [&](const std::vector<int>& a, const std::vector<int>& b) {
    const auto size_a = size_of(a);
    const auto size_b = size_of(b);
    return size_a != size_b ? size_a > size_b : a.front() < b.front();
  });
  return clusters;
}

/// The clusters at a time up to which every particle flies straight, with the extent and the relative
/// velocity of the largest one: with positions x, velocities v, masses m and their mass-weighted means X, V
///   extent = √(Σ|x − X|² / n), relative speed = √(Σ|v − V|² / n), centre speed = |V|.
template <typename Scalar, int D>
ClusterSample sample_clusters(const World<Scalar, D>& world, const Time<Scalar>& t, std::string occasion) {
  using Vec = Vector<Scalar, D>;
  using std::sqrt;
  const ClusterObservation& observed = *world.scene.clusters;
  const std::vector<std::vector<int>> clusters = clusters_of(world, observed);
  ClusterSample sample;
  sample.t = static_cast<double>(t.hi);
  sample.occasion = std::move(occasion);
  for (const std::vector<int>& cluster : clusters) {
    sample.sizes.push_back(static_cast<int>(std::count_if(
        cluster.begin(), cluster.end(), [&](int i) { return world.species(i) == observed.species; })));
  }
  if (clusters.empty()) return sample;
  const std::vector<int>& largest = clusters.front();
  Scalar mass(0);
  Vec centre = Vec::Zero();
  Vec velocity = Vec::Zero();
  for (const int i : largest) {
    mass += world.mass(i);
    centre += world.mass(i) * world.position(i, t);
    velocity += world.mass(i) * world.velocity(i);
  }
  centre /= mass;
  velocity /= mass;
  Scalar spread(0);
  Scalar agitation(0);
  for (const int i : largest) {
    spread += (world.position(i, t) - centre).squaredNorm();
    agitation += (world.velocity(i) - velocity).squaredNorm();
  }
  const Scalar n(static_cast<int>(largest.size()));
  sample.extent = static_cast<double>(Scalar(sqrt(Scalar(spread / n))));
  sample.relative_speed = static_cast<double>(Scalar(sqrt(Scalar(agitation / n))));
  sample.centre_speed = static_cast<double>(Scalar(sqrt(velocity.squaredNorm())));
  return sample;
}

/// When a run looks at its clusters: twenty times in a finite duration, at its ends, and around every
/// impulse.
class ClusterSchedule {
 public:
  struct Moment {
    double at;
    bool before_events;  ///< of the same time
    std::string occasion;
  };

  ClusterSchedule(const Scene& scene, double duration) {
    if (!scene.clusters) return;
    constexpr int kSamples = 20;
    const bool finite = duration < std::numeric_limits<double>::infinity();
    for (int n = 0; n <= (finite ? kSamples : 0); ++n) {
      moments_.push_back({n == 0 ? 0 : duration * n / kSamples, n == 0, "sample"});
    }
    for (const ScheduledImpulse& impulse : scene.impulses) {
      if (impulse.at > duration) continue;
      moments_.push_back({impulse.at, true, "before impulse"});
      moments_.push_back({impulse.at, false, "after impulse"});
    }
    std::stable_sort(moments_.begin(), moments_.end(), [](const Moment& a, const Moment& b) {
      return a.at != b.at ? a.at < b.at : a.before_events && !b.before_events;
    });
    const auto same = [](const Moment& a, const Moment& b) {
      return a.at == b.at && a.before_events == b.before_events && a.occasion == b.occasion;
    };
    moments_.erase(std::unique(moments_.begin(), moments_.end(), same), moments_.end());
  }

  /// Takes every sample that is due before an event at time `next`.
  template <typename Scalar, int D>
  void sample_until(const World<Scalar, D>& world, const Time<Scalar>& next,
                    std::vector<ClusterSample>& samples) {
    while (samples.size() < moments_.size()) {
      const Moment& moment = moments_[samples.size()];
      const Time<Scalar> at{Scalar(moment.at), Scalar(0)};
      if (moment.before_events ? next < at : next <= at) return;
      samples.push_back(sample_clusters(world, at, moment.occasion));
    }
  }

 private:
  std::vector<Moment> moments_;
};

}  // namespace tps
