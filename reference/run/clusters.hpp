// Clusters: connected components of tethers, and how a cluster moves.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "reference/engine/world.hpp"
#include "reference/run/run.hpp"

namespace tps {

/// The components of a graph of tethers (permanent ones do not count) that hold enough of the observed
/// species, the largest first; each ascending. Of equally large ones the one with the smallest particle is
/// first.
std::vector<std::vector<int>> clusters_of(const Scene& scene, const std::vector<Tether>& tethers,
                                          const ClusterObservation& observed);

/// How many particles of a species there are among some.
int count_species(const Scene& scene, const std::vector<int>& particles, int species);

/// The clusters at a time up to which every particle flies straight, with the extent and the relative
/// velocity of the largest one: with positions x, velocities v, masses m and their mass-weighted means X, V
///   extent = √(Σ|x − X|² / n), relative speed = √(Σ|v − V|² / n), centre speed = |V|.
template <typename Scalar, int D>
ClusterSample sample_clusters(const World<Scalar, D>& world, const Time<Scalar>& t, std::string occasion) {
  using Vec = Vector<Scalar, D>;
  using std::sqrt;
  const ClusterObservation& observed = *world.scene.clusters;
  std::vector<Tether> tethers;
  for (int i = 0; i < world.size(); ++i) {
    for (const int j : world.tethers.of(i)) {
      if (i < j) tethers.push_back({i, j});
    }
  }
  const std::vector<std::vector<int>> clusters = clusters_of(world.scene, tethers, observed);
  ClusterSample sample;
  sample.t = static_cast<double>(t.hi);
  sample.occasion = std::move(occasion);
  for (const std::vector<int>& cluster : clusters) {
    sample.sizes.push_back(count_species(world.scene, cluster, observed.species));
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
  const auto n = static_cast<Scalar>(static_cast<int>(largest.size()));
  sample.extent = static_cast<double>(Scalar(sqrt(Scalar(spread / n))));
  sample.relative_speed = static_cast<double>(Scalar(sqrt(Scalar(agitation / n))));
  sample.centre_speed = static_cast<double>(Scalar(sqrt(velocity.squaredNorm())));
  return sample;
}

/// When a run looks at its clusters: twenty times in a finite duration, at its ends, and around every
/// impulse.
class ClusterSchedule {
 public:
  ClusterSchedule(const Scene& scene, double duration);

  /// Takes every sample that is due before an event at time `next`.
  template <typename Scalar, int D>
  void sample_until(const World<Scalar, D>& world, const Time<Scalar>& next,
                    std::vector<ClusterSample>& samples) const {
    while (samples.size() < moments_.size()) {
      const Moment& moment = moments_[samples.size()];
      const Time<Scalar> at{Scalar(moment.at), Scalar(0)};
      if (moment.before_events ? next < at : next <= at) return;
      samples.push_back(sample_clusters(world, at, moment.occasion));
    }
  }

 private:
  struct Moment {
    double at;
    bool before_events;  ///< of the same time
    std::string occasion;
  };
  std::vector<Moment> moments_;
};

}  // namespace tps
