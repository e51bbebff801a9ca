// The impulses from outside that a scene has ahead, each kind in the order of its times.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "reference/scene/random_kicks.hpp"
#include "reference/scene/scene.hpp"
#include "verify/trace_check/line.hpp"

namespace tps::check {

struct OutsideKick {
  double at;
  int particle;              ///< −1: everybody
  std::uint32_t number = 0;  ///< of the particle's own, where times are random
};

/// Follows the draws of the scene's seed by our generator, which is the reference's own code: what a trace
/// says of them is judged as far as that generator is right, which its statistics and known answers test.
class OutsideKicks {
 public:
  explicit OutsideKicks(const Scene& scene);

  std::optional<OutsideKick> next(Kind kind) const;
  /// The next one of a kind has happened. REQUIRES that there is one.
  void take(Kind kind);
  const ScheduledImpulse& scheduled() const { return scheduled_[scheduled_done_]; }
  std::uint64_t gravity_done() const { return gravity_done_; }
  std::size_t scheduled_done() const { return scheduled_done_; }

 private:
  struct Random {
    std::map<int, PoissonTimes> times;         ///< by particle
    std::set<std::pair<double, int>> waiting;  ///< (time, particle)
  };
  void add_random(const Scene& scene, Kind kind, Purpose wait, int particle, double tau);

  std::vector<ScheduledImpulse> scheduled_;  ///< in their order
  std::size_t scheduled_done_ = 0;
  std::optional<Gravity> gravity_;
  std::uint64_t gravity_done_ = 0;
  std::map<Kind, Random> random_;
};

}  // namespace tps::check
