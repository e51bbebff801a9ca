#include "reference/run/clusters.hpp"

#include <algorithm>
#include <limits>

namespace tps {

ClusterSchedule::ClusterSchedule(const Scene& scene, double duration) {
  if (!scene.clusters) return;
  constexpr int kSamples = 20;
  const bool finite = duration < std::numeric_limits<double>::infinity();
  for (int n = 0; n <= (finite ? kSamples : 0); ++n) {
    moments_.push_back({n == 0 ? 0 : duration * n / kSamples, n == 0, "sample", std::nullopt});
  }
  for (const ScheduledImpulse& impulse : scene.impulses) {
    if (impulse.at > duration) continue;
    const std::string on =
        " on " + std::to_string(scene.particles[static_cast<std::size_t>(impulse.particle)].id);
    moments_.push_back({impulse.at, true, "before impulse" + on, impulse.particle});
    moments_.push_back({impulse.at, false, "after impulse" + on, impulse.particle});
    const double later = impulse.at + duration / kSamples;
    if (later <= duration) moments_.push_back({later, false, "later" + on, impulse.particle});
  }
  std::stable_sort(moments_.begin(), moments_.end(), [](const ClusterMoment& a, const ClusterMoment& b) {
    return a.at != b.at ? a.at < b.at : a.before_events && !b.before_events;
  });
}

}  // namespace tps
