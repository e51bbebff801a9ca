// The event loop: take the next event, let its effect respond, predict again what changed.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reference/engine/all_pairs.hpp"
#include "reference/engine/cells/cells.hpp"
#include "reference/engine/detector.hpp"
#include "reference/engine/effect.hpp"
#include "reference/engine/effect_catalogue.hpp"
#include "reference/engine/energy.hpp"
#include "reference/engine/next_event.hpp"
#include "reference/engine/world.hpp"

namespace tps {

/// Why a run ended.
enum class EndReason { duration, max_events, no_more_events, stalled, interrupted, out_of_range };

constexpr std::string_view name(EndReason reason) {
  switch (reason) {
    case EndReason::duration:
      return "duration";
    case EndReason::max_events:
      return "max_events";
    case EndReason::no_more_events:
      return "no_more_events";
    case EndReason::stalled:
      return "stalled";
    case EndReason::interrupted:
      return "interrupted";
    case EndReason::out_of_range:
      return "out_of_range";
  }
  return "unknown";
}

/// A run of one scene in one scalar type. It has no randomness of its own and depends on nothing but the
/// scene.
template <typename Scalar, int D>
class Simulation {
 public:
  /// The scene is not copied and must outlive the simulation. Throws OutOfRange.
  explicit Simulation(Scene&&, const TimingChoice& = {}, DetectorKind = {}) = delete;
  explicit Simulation(const Scene& scene, const TimingChoice& timing = {}, DetectorKind detector = {})
      : world_(scene, timing), effects_(called_effects<Scalar, D>(scene)), detector_(made(detector, timing)) {
    world_.coupling = std::make_unique<FreeCoupling<Scalar, D>>();
    for (std::size_t n = 0; n < effects_.size(); ++n) effects_[n]->begin(world_, static_cast<int>(n));
    world_.ledger.kinetic_at_start = kinetic_energy(world_);
    world_.ledger.momentum_at_start = momentum(world_);
    require_range<Scalar, D>(world_.ledger);
    predict_everything();
  }

  World<Scalar, D>& world() { return world_; }
  const World<Scalar, D>& world() const { return world_; }
  const std::vector<std::unique_ptr<Effect<Scalar, D>>>& effects() const { return effects_; }

  /// Nobody will ask for events beyond this time. A run that ends at some time says so, since many particles
  /// that meet nobody any more are otherwise followed until it is certain that they never will.
  /// REQUIRES that nobody has asked for an event yet.
  void set_horizon(const Time<Scalar>& horizon) { horizon_ = horizon; }

  /// The time of the next event; never() if there is none. Where there is none up to the horizon, some time
  /// beyond it.
  Time<Scalar> next_time() { return next_event().time; }

  /// Who has an event behind `last`, where nothing is due up to it: by default one that no time of the scalar
  /// reaches.
  std::optional<std::string> waits_behind(const Time<Scalar>& last = {(std::numeric_limits<Scalar>::max)(),
                                                                      Scalar(0)}) {
    const std::optional<PendingEvent<Scalar>>& next = next_event().event;
    if (!next || next->rank < Rank::wall || next->time <= last) return std::nullopt;
    if (next->rank == Rank::wall) return particle_name(world_.scene, next->first) + " and a wall";
    return pair_name(world_.scene, next->first, next->second);
  }

  /// Processes the next event. REQUIRES that there is one up to the horizon. Throws OutOfRange: then the
  /// state is not one of a run any more.
  ///
  /// (1) advance the clock, (2) respond, (3) predict again the pairs of whatever was touched.
  void step() {
    const PendingEvent<Scalar> event = *next_event().event;
    next_.reset();
    note_progress(event.time);
    world_.now = event.time;
    effects_[World<Scalar, D>::index(event.effect)]->respond(world_, event);
    predict_touched();
  }

  /// The numerical definition of a stall (docs/engine.md): more than stall_limit() events in a row while the
  /// clock, rounded to the scalar, stood still.
  bool stalled() const { return world_.events - progress_event_ > stall_limit(); }

  /// 10 000 + N(N − 1)/2: what N bodies can legitimately have at one instant (a row of touching equal masses
  /// sorts its velocities in N(N − 1)/2 collisions), and an allowance for three-body chains near collapse.
  std::uint64_t stall_limit() const {
    const std::uint64_t n = world_.particles.size();
    return 10000 + n * (n - 1) / 2;
  }

  /// Number of the event at which the clock last moved.
  std::uint64_t progress_event() const { return progress_event_; }

  /// Takes up a state that was put into world() from outside: predicts everything again. Because a prediction
  /// is a function of stored states, the run goes on as if it had never stopped.
  void resume(std::uint64_t progress_event) {
    progress_event_ = progress_event;
    world_.forget_places();
    world_.queue = {};
    next_.reset();
    predict_everything();
  }

 private:
  std::unique_ptr<Detector<Scalar, D>> made(DetectorKind kind, const TimingChoice& timing) const {
    const bool many = world_.size() >= Cells<Scalar, D>::kWorthwhile;
    const bool fits = Cells<Scalar, D>::fits(world_.scene, timing);
    if (fits && (kind == DetectorKind::cells || (kind == DetectorKind::automatic && many)))
      return std::make_unique<Cells<Scalar, D>>(world_, timing, effects_);
    return std::make_unique<AllPairs<Scalar, D>>(effects_);
  }

  void predict_everything() {
    for (const auto& effect : effects_) effect->queue_known(world_);
    detector_->predict_all(world_);
  }

  /// Out of the queue already; kept until step() takes it.
  const ChosenEvent<Scalar>& next_event() {
    if (!next_) next_ = choice_.take(world_, *detector_, effects_, horizon_);
    return *next_;
  }

  void note_progress(const Time<Scalar>& time) {
    if (time.hi != world_.now.hi) progress_event_ = world_.events;
  }

  void predict_touched() {
    const std::vector<int>& touched = world_.take_touched();
    for (const auto& effect : effects_) effect->refresh(world_, touched);
    detector_->predict_touched(world_, touched);
  }

  World<Scalar, D> world_;
  std::vector<std::unique_ptr<Effect<Scalar, D>>> effects_;
  std::unique_ptr<Detector<Scalar, D>> detector_;
  NextEventChoice<Scalar, D> choice_;
  Time<Scalar> horizon_ = Time<Scalar>::never();
  std::optional<ChosenEvent<Scalar>> next_;
  std::uint64_t progress_event_ = 0;
};

}  // namespace tps
