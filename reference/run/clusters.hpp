// How the clusters of a run move, and when a run looks at them.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "reference/engine/world.hpp"
#include "reference/run/run.hpp"
#include "reference/scene/clusters.hpp"

namespace tps {

/// Extent and motion of one cluster at a time up to which every particle flies straight: with masses m of sum
/// M, positions x, velocities v, and their mass-weighted means X, V
///   extent = √(Σ m|x − X|² / M), relative speed = √(Σ m|v − V|² / M), centre speed = |V|.
/// Those of infinite mass, which no collision moves, are counted and not in the sums.
/// With the weights ½ M (relative speed)² is the energy of the inner motion, which collisions inside the
/// cluster cannot raise. Without them it would rise as heavy vesicles share their energy with light
/// synapsins.
template <typename Scalar, int D>
void describe_cluster(const World<Scalar, D>& world, const Time<Scalar>& t, const std::vector<int>& members,
                      ClusterSample& sample) {
  using Vec = Vector<Scalar, D>;
  using std::frexp;
  using std::ldexp;
  sample.described = count_species(world.scene, members, world.scene.clusters->species);
  sample.particles = static_cast<int>(members.size());
  std::vector<int> cluster = members;
  std::erase_if(cluster, [&](int i) { return world.fixed(i); });
  if (cluster.empty()) return;
  int exponent = std::numeric_limits<int>::min();
  for (const int i : cluster) {
    int own = 0;
    static_cast<void>(frexp(world.mass(i), &own));
    exponent = std::max(exponent, own);
  }
  const auto weight = [&](int i) { return Scalar(ldexp(world.mass(i), -exponent)); };
  Scalar mass(0);
  Vec centre = Vec::Zero();
  Vec velocity = Vec::Zero();
  for (const int i : cluster) {
    mass += weight(i);
    centre += weight(i) * world.position(i, t);
    velocity += weight(i) * world.velocity(i);
  }
  centre /= mass;
  velocity /= mass;
  // √(Σ m x²/M): masses and lengths by powers of two, so that no product leaves the range.
  const auto mean = [&](const auto& of) {
    Vec largest = Vec::Zero();
    for (const int i : cluster) largest = largest.cwiseMax(Vec(of(i)).cwiseAbs());
    const int shift = comfortable_shift<Scalar, D>(largest);
    Scalar sum(0);
    for (const int i : cluster) sum += weight(i) * shifted<Scalar, D>(Vec(of(i)), shift).squaredNorm();
    return static_cast<double>(Scalar(ldexp(Scalar(square_root(Scalar(sum / mass))), -shift)));
  };
  sample.mass = static_cast<double>(Scalar(ldexp(mass, exponent)));
  sample.extent = mean([&](int i) { return Vec(world.position(i, t) - centre); });
  sample.relative_speed = mean([&](int i) { return Vec(world.velocity(i) - velocity); });
  sample.centre_speed = static_cast<double>(norm<Scalar, D>(velocity));
  for (int k = 0; k < D; ++k)
    sample.centre_velocity[static_cast<std::size_t>(k)] = static_cast<double>(velocity[k]);
  if (!is_finite(sample.extent) || !is_finite(sample.relative_speed) || !is_finite(sample.centre_speed) ||
      !is_finite(sample.mass)) {
    throw OutOfRange("the size of the cluster of " + particle_name(world.scene, cluster.front()));
  }
}

/// When a run looks at its clusters, and at which one.
struct ClusterMoment {
  double at;
  bool before_events;  ///< of the same time
  std::string occasion;
  std::optional<int> around;  ///< describe the cluster of this particle; none: the largest one
};

/// The clusters at a moment up to which every particle flies straight.
template <typename Scalar, int D>
ClusterSample sample_clusters(const World<Scalar, D>& world, const ClusterMoment& moment) {
  const Time<Scalar> t{Scalar(moment.at), Scalar(0)};
  std::vector<Tether> tethers;
  for (int i = 0; i < world.size(); ++i) {
    for (const int j : world.tethers.of(i)) {
      if (i < j) tethers.push_back({i, j});
    }
  }
  ClusterSample sample;
  sample.t = moment.at;
  sample.occasion = moment.occasion;
  const std::vector<int>* described = nullptr;
  const std::vector<std::vector<int>> clusters = clusters_of(world.scene, tethers, *world.scene.clusters);
  for (const std::vector<int>& cluster : clusters) {
    sample.sizes.push_back(count_species(world.scene, cluster, world.scene.clusters->species));
    const bool wanted = moment.around ? std::binary_search(cluster.begin(), cluster.end(), *moment.around)
                                      : described == nullptr;
    if (wanted) described = &cluster;
  }
  if (described != nullptr) describe_cluster(world, t, *described, sample);
  return sample;
}

/// When a run looks at its clusters: twenty times in a finite duration, at its ends, and around every
/// impulse. The duration is the scene's, wherever the run ends, so that a run that was cut short and taken up
/// again has the samples of one that was not.
class ClusterSchedule {
 public:
  ClusterSchedule(const Scene& scene, double duration);

  /// Takes every sample that is due before an event at time `next`.
  template <typename Scalar, int D>
  void sample_until(const World<Scalar, D>& world, const Time<Scalar>& next,
                    std::vector<ClusterSample>& samples) const {
    while (samples.size() < moments_.size()) {
      const ClusterMoment& moment = moments_[samples.size()];
      const Time<Scalar> at{Scalar(moment.at), Scalar(0)};
      if (moment.before_events ? next < at : next <= at) return;
      samples.push_back(sample_clusters(world, moment));
    }
  }

 private:
  std::vector<ClusterMoment> moments_;
};

}  // namespace tps
