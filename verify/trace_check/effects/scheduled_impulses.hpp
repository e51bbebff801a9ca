// Rules earliest and impulse, for impulses that the scene has at given times.
#pragma once

#include "verify/trace_check/rules/outside_impulse.hpp"

namespace tps::check::effects {

template <typename Number>
class ScheduledImpulses final : public EffectRules<Number> {
 public:
  explicit ScheduledImpulses(const Scene& scene) : impulses_(scene.impulses) {
    std::stable_sort(impulses_.begin(), impulses_.end(),
                     [](const ScheduledImpulse& a, const ScheduledImpulse& b) {
                       return std::tie(a.at, a.particle) < std::tie(b.at, b.particle);
                     });
  }

  std::string_view effect() const override { return "scheduled_impulses"; }
  int rank() const override { return 20; }
  std::string what() const override { return "scheduled impulse"; }
  std::uint64_t progress() const override { return done_; }

  std::optional<EventAhead> next(const Context<Number>&) const override {
    if (done_ == impulses_.size()) return std::nullopt;
    return EventAhead{impulses_[done_].at, impulses_[done_].particle};
  }
  void pass(const Context<Number>&) override { ++done_; }

  /// Δp is that of the scene, rounded once.
  void judge(const Context<Number>& c, const EventLine<Number>& event) const override {
    judge_kick(c, event, next(c), [&] {
      return KickImpulse<Number>{stored_vector(c, impulses_[done_].impulse), Work<Number>(0)};
    });
  }

 private:
  std::vector<ScheduledImpulse> impulses_;  ///< in their order
  std::size_t done_ = 0;
};

struct scheduled_impulses {
  template <typename Number>
  static std::unique_ptr<EffectRules<Number>> make(const Scene& scene) {
    return std::make_unique<ScheduledImpulses<Number>>(scene);
  }
};

}  // namespace tps::check::effects
