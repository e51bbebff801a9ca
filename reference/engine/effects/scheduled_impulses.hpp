// Scheduled impulses: J on a particle at a given time, an "impact" of the paper.
#pragma once

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <tuple>

#include "reference/engine/effect.hpp"
#include "reference/engine/effect_records.hpp"
#include "reference/engine/outside_impulse.hpp"
#include "reference/engine/world.hpp"

namespace tps::effects {

template <typename Scalar, int D>
class ScheduledImpulses final : public Effect<Scalar, D> {
 public:
  std::string_view name() const override { return "scheduled_impulses"; }

  explicit ScheduledImpulses(const Scene& scene) : impulses_(scene.impulses) {
    std::stable_sort(impulses_.begin(), impulses_.end(),
                     [](const ScheduledImpulse& a, const ScheduledImpulse& b) {
                       return std::tie(a.at, a.particle) < std::tie(b.at, b.particle);
                     });
  }

  void begin(World<Scalar, D>&, int self) override { self_ = self; }
  void queue_known(World<Scalar, D>& world) override { queue_next(world); }

  void respond(World<Scalar, D>& world, const PendingEvent<Scalar>&) override {
    const ScheduledImpulse& impulse = impulses_[done_++];
    const Vector<Scalar, D> J = lifted<Scalar, D>(impulse.impulse);
    Record<Scalar, D> record = world.open_record("scheduled_impulse", impulse.particle, impulse.particle);
    push_from_outside(world, impulse.particle, J, record);
    world.close_record(record);
    queue_next(world);
  }

  std::uint64_t progress() const override { return done_; }
  void resume(World<Scalar, D>&, std::uint64_t progress) override {
    if (progress > impulses_.size()) throw std::out_of_range("more impulses than the scene has");
    done_ = progress;
  }

 private:
  static constexpr Rank kRank{20};
  /// One impulse is queued at a time, in the order (time, particle), and no change of a particle voids it.
  void queue_next(World<Scalar, D>& world) {
    if (done_ == impulses_.size()) return;
    const ScheduledImpulse& next = impulses_[done_];
    world.queue.push(
        world.pending({Scalar(next.at), Scalar(0)}, kRank, -1, -1, static_cast<int>(done_), self_));
  }

  std::vector<ScheduledImpulse> impulses_;
  std::size_t done_ = 0;
  int self_ = 0;
};

struct scheduled_impulses {
  static EffectCall call(const Scene& scene) {
    EffectCall call{"scheduled_impulses", "impulses from outside at given times", {}, "\"impulses\"", {}};
    if (!scene.impulses.empty()) call.because.push_back(key_of_scene("impulses"));
    call.cost = std::to_string(scene.impulses.size()) + " events";
    return call;
  }
  static EffectRecords records(const Scene& scene) {
    return {.kinds = {{"scheduled_impulse", About::particle}},
            .known = {{scene.impulses.size(), "is more than the impulses of the scene"}}};
  }
  template <typename Scalar, int D>
  static std::unique_ptr<Effect<Scalar, D>> make(const Scene& scene) {
    return std::make_unique<ScheduledImpulses<Scalar, D>>(scene);
  }
};

}  // namespace tps::effects
