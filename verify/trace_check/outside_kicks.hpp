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
  /// So many of a kind have happened. Throws std::out_of_range where the scene has fewer. Of random ones each
  /// takes its time: the times are sums.
  void pass_over(Kind kind, std::uint64_t count);
  /// How many of a kind have happened.
  std::uint64_t taken(Kind kind) const;
  const ScheduledImpulse& scheduled() const { return scheduled_[scheduled_done_]; }
  std::uint64_t gravity_done() const { return gravity_done_; }
  std::size_t scheduled_done() const { return scheduled_done_; }

 private:
  struct Random {
    std::map<int, PoissonTimes> times;         ///< by particle
    std::set<std::pair<double, int>> waiting;  ///< (time, particle)
    std::uint64_t taken = 0;
  };
  void add_random(const Scene& scene, Kind kind, Purpose wait, int particle, double tau);

  std::vector<ScheduledImpulse> scheduled_;  ///< in their order
  std::size_t scheduled_done_ = 0;
  std::optional<Gravity> gravity_;
  std::uint64_t gravity_done_ = 0;
  std::map<Kind, Random> random_;
};

}  // namespace tps::check
