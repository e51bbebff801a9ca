// Drag, dv/dt = −γ v of everybody: in s = (1 − e^{−γt})/γ motion is straight. The run is that of the scene
// without drag, on the clock s: u' = du/ds = v e^{γt} is constant between collisions, eq. (2) gives their s,
// and eqs. (3) to (5), which are homogeneous in velocities, hold for u' as for v. docs/effects.md, "Drag".
//
// Laws: (1) events with γ s ≥ 1 never happen; (2) a free particle comes to rest after the way |v|/γ; (3) the
// order of events is that of their s, without a logarithm; (4) kinetic energies of the scene are those of the
// run times (1 − γs)²: what drag takes and what collisions lose add up to what is missing.
#pragma once

#include <algorithm>
#include <memory>

#include "reference/engine/coupling.hpp"
#include "reference/engine/effect.hpp"
#include "reference/engine/effect_records.hpp"
#include "reference/engine/world.hpp"

namespace tps {

/// Collisions as without drag, with the energies that they cost the scene.
template <typename Scalar, int D>
class DragCoupling final : public FreeCoupling<Scalar, D> {
 public:
  explicit DragCoupling(const Scalar& gamma) : gamma_(gamma) {}

  void collide(World<Scalar, D>& world, const Collision<Scalar, D>& c, Record<Scalar, D>& record) override {
    note(world, c.loss);
    FreeCoupling<Scalar, D>::collide(world, c, record);
  }
  void lose(World<Scalar, D>& world, const Scalar& loss) override {
    note(world, loss);
    world.ledger.lost += loss;
  }

  /// 1 − γ s = e^{−γt}, at most 3u off.
  Scalar velocity_unit(const Time<Scalar>& s) const override {
    return std::max(Scalar(Scalar(1) - gamma_ * s.hi) - gamma_ * s.lo, Scalar(0));
  }
  /// Kinetic energy of the scene that collisions have cost, Σ (1 − γs)² times that of the run.
  Scalar lost(const World<Scalar, D>&) const override { return lost_.value(); }
  /// What drag has taken from the start until `end`, which is not before the last collision.
  Scalar taken(const World<Scalar, D>& world, const Time<Scalar>& end) const override {
    return taken_.value() + energy_taken(world, end);
  }

  using Numbers = typename Effect<Scalar, D>::Numbers;
  Numbers numbers() const {
    return {{"drag_lost", {lost_.total(), lost_.rest()}},
            {"drag_taken", {taken_.total(), taken_.rest()}},
            {"drag_since", {since_.hi, since_.lo}}};
  }
  void take_numbers(const Numbers& numbers) {
    const auto& lost = numbers.at("drag_lost");
    const auto& taken = numbers.at("drag_taken");
    const auto& since = numbers.at("drag_since");
    lost_ = {lost[0], lost[1]};
    taken_ = {taken[0], taken[1]};
    since_ = {since[0], since[1]};
  }

 private:
  /// A loss of the run now.
  void note(const World<Scalar, D>& world, const Scalar& loss) {
    taken_ += energy_taken(world, world.now);
    since_ = world.now;
    const Scalar f = velocity_unit(world.now);
    lost_ += loss * f * f;
  }

  /// Since the last collision the run's kinetic energy is K, what the ledger has left of that at the start:
  /// drag takes K (f² − f'²) = K γ Δs (f + f').
  Scalar energy_taken(const World<Scalar, D>& world, const Time<Scalar>& end) const {
    const Scalar kinetic = world.ledger.kinetic_at_start - world.ledger.lost.value();
    return kinetic * (gamma_ * elapsed(since_, end)) * Scalar(velocity_unit(since_) + velocity_unit(end));
  }

  Scalar gamma_;
  Sum<Scalar> lost_, taken_;
  Time<Scalar> since_;
};

namespace effects {

template <typename Scalar, int D>
class Drag final : public Effect<Scalar, D> {
 public:
  std::string_view name() const override { return "drag"; }

  void begin(World<Scalar, D>& world, int) override {
    auto coupling = std::make_unique<DragCoupling<Scalar, D>>(Scalar(world.scene.drag->gamma));
    coupling_ = coupling.get();
    world.coupling = std::move(coupling);
  }
  void respond(World<Scalar, D>&, const PendingEvent<Scalar>&) override {}  // it has no events

  typename Effect<Scalar, D>::Numbers numbers(const World<Scalar, D>&) const override {
    return coupling_->numbers();
  }
  void take_numbers(World<Scalar, D>&, const typename Effect<Scalar, D>::Numbers& numbers) override {
    coupling_->take_numbers(numbers);
  }
  typename Effect<Scalar, D>::Energies energies(const World<Scalar, D>& world,
                                                const Time<Scalar>& end) const override {
    return {{"taken", coupling_->taken(world, end)}};
  }

 private:
  DragCoupling<Scalar, D>* coupling_ = nullptr;  ///< owned by the world
};

struct drag {
  static EffectCall call(const Scene& scene) {
    EffectCall call{"drag", "dv/dt = -γ v: straight paths in s = (1 - exp(-γ t)) / γ", {}, "\"drag\"", {}};
    if (scene.drag) call.because.push_back(key_of_scene("drag"));
    call.cost = "no event; a logarithm an event for the printed time";
    return call;
  }
  static EffectRecords records(const Scene&) {
    return {.quantities = {{"drag_lost"}, {"drag_taken"}, {"drag_since"}}};
  }
  template <typename Scalar, int D>
  static std::unique_ptr<Effect<Scalar, D>> make(const Scene&) {
    return std::make_unique<Drag<Scalar, D>>();
  }
};

}  // namespace effects
}  // namespace tps
