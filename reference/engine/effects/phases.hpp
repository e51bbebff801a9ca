// Phases: windows of time in which a pair of species follows other tether rules (semantics §3).
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>
#include <tuple>

#include "reference/engine/effect.hpp"
#include "reference/engine/effect_records.hpp"
#include "reference/engine/world.hpp"

namespace tps::effects {

template <typename Scalar, int D>
class Phases final : public Effect<Scalar, D> {
 public:
  std::string_view name() const override { return "phases"; }

  explicit Phases(const Scene& scene) : active_(scene.phases.size(), false) {
    for (std::size_t n = 0; n < scene.phases.size(); ++n) {
      changes_.push_back({scene.phases[n].from, true, n});
      if (scene.phases[n].until < std::numeric_limits<double>::infinity()) {
        changes_.push_back({scene.phases[n].until, false, n});
      }
    }
    // At one time, windows close before others open: a window holds for from <= t < until.
    std::sort(changes_.begin(), changes_.end(), [](const Change& a, const Change& b) {
      return std::tie(a.at, a.opens, a.phase) < std::tie(b.at, b.opens, b.phase);
    });
  }

  void begin(World<Scalar, D>&, int self) override { self_ = self; }
  void queue_known(World<Scalar, D>& world) override { queue_next(world); }

  void respond(World<Scalar, D>& world, const PendingEvent<Scalar>&) override {
    const Change change = changes_[done_];
    apply_next(world);
    Record<Scalar, D> record;
    record.kind = change.opens ? "phase_begin" : "phase_end";
    addition_.phase = static_cast<int>(change.phase);
    record.addition = &addition_;
    world.close_record(record);
    queue_next(world);
  }

  std::uint64_t progress() const override { return done_; }
  void resume(World<Scalar, D>& world, std::uint64_t progress) override {
    if (progress > changes_.size()) throw std::out_of_range("more phase changes than the scene has");
    while (done_ < progress) apply_next(world);
  }

 private:
  static constexpr Rank kRank{10};
  struct Change {
    double at;
    bool opens;
    std::size_t phase;
  };

  void apply_next(World<Scalar, D>& world) {
    const Change& change = changes_[done_++];
    active_[change.phase] = change.opens;
    const Phase& changed = world.scene.phases[change.phase];
    for (const PairLaw& pair : world.scene.pairs) {
      if (pair.species_a != changed.species_a || pair.species_b != changed.species_b) continue;
      FormRule form = pair.tethering->form;
      BreakRule breaks = pair.tethering->breaks;
      for (std::size_t n = 0; n < active_.size(); ++n) {
        const Phase& phase = world.scene.phases[n];
        if (!active_[n] || phase.species_a != pair.species_a || phase.species_b != pair.species_b) continue;
        if (phase.form) form = *phase.form;
        if (phase.breaks) breaks = *phase.breaks;
      }
      world.laws.replace_rules(pair.species_a, pair.species_b, form, breaks);
    }
  }

  void queue_next(World<Scalar, D>& world) {
    if (done_ == changes_.size()) return;
    world.queue.push(world.pending({Scalar(changes_[done_].at), Scalar(0)}, kRank, -1, -1,
                                   static_cast<int>(done_), self_));
  }

  std::vector<Change> changes_;
  std::vector<bool> active_;
  std::size_t done_ = 0;
  int self_ = 0;
  Addition<Scalar, D> addition_;
};

struct phases {
  static EffectCall call(const Scene& scene) {
    EffectCall call{"phases", "other tether rules for a pair of species for a while", {}, "\"phases\"", {}};
    if (!scene.phases.empty()) call.because.push_back(key_of_scene("phases"));
    call.cost = std::to_string(scene.phases.size()) + " windows, at most two events each";
    return call;
  }
  static EffectRecords records(const Scene& scene) {
    const auto ending = std::count_if(scene.phases.begin(), scene.phases.end(),
                                      [](const Phase& phase) { return std::isfinite(phase.until); });
    return {.kinds = {{"phase_begin", About::rules, {"phase"}}, {"phase_end", About::rules, {"phase"}}},
            .known = {{scene.phases.size() + static_cast<std::uint64_t>(ending),
                       "is more than the phases of the scene begin and end"}}};
  }
  template <typename Scalar, int D>
  static std::unique_ptr<Effect<Scalar, D>> make(const Scene& scene) {
    return std::make_unique<Phases<Scalar, D>>(scene);
  }
};

}  // namespace tps::effects
