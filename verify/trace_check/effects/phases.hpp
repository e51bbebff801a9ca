// Rule earliest, for phases: windows of time in which a pair of species follows other tether rules. Which
// rule is in force is worked out here and not asked of the engine, whose fault it may be (docs/decisions.md,
// L10).
#pragma once

#include "verify/trace_check/rules/known_events.hpp"

namespace tps::check::effects {

template <typename Number>
class Phases final : public EffectRules<Number> {
 public:
  explicit Phases(const Scene& scene) : scene_(scene), is_open_(scene.phases.size(), false) {
    for (std::size_t n = 0; n < scene.phases.size(); ++n) {
      changes_.push_back({scene.phases[n].from, true, n});
      if (!std::isinf(scene.phases[n].until)) changes_.push_back({scene.phases[n].until, false, n});
    }
    // At one time, windows close before others open.
    std::sort(changes_.begin(), changes_.end(), [](const Change& a, const Change& b) {
      return std::tie(a.at, a.opens, a.phase) < std::tie(b.at, b.opens, b.phase);
    });
  }

  std::string_view effect() const override { return "phases"; }
  int rank() const override { return 10; }
  std::string what() const override { return "phase change"; }
  std::uint64_t progress() const override { return done_; }

  std::optional<EventAhead> next(const Context<Number>&) const override {
    if (done_ == changes_.size()) return std::nullopt;
    return EventAhead{changes_[done_].at};
  }

  void pass(const Context<Number>& c) override {
    const Change& change = changes_[done_++];
    is_open_[change.phase] = change.opens;
    const Phase& changed = scene_.phases[change.phase];
    for (const PairLaw& law : scene_.pairs) {
      if (is_of(changed, law)) set_rules(c.model.rules, law);
    }
  }

  void judge(const Context<Number>& c, const EventLine<Number>& event) const override {
    const bool opens = name(event.kind) == "phase_begin";
    const bool there = done_ < changes_.size() && changes_[done_].opens == opens &&
                       changes_[done_].phase == static_cast<std::size_t>(*event.phase);
    c.tally.demand(Rule::earliest, there, [&](Finding& f) {
      f.message = fmt::format("{} of phase {} is not the scene's next change of a phase", name(event.kind),
                              *event.phase);
    });
    if (there) judge_scheduled_time(c, event, changes_[done_].at, what());
  }

 private:
  struct Change {
    double at;
    bool opens;
    std::size_t phase;
  };

  static bool is_of(const Phase& phase, const PairLaw& law) {
    return phase.species_a == law.species_a && phase.species_b == law.species_b;
  }

  void set_rules(RuleTable<Number>& rules, const PairLaw& law) const {
    FormRule form = law.tethering->form;
    BreakRule breaks = law.tethering->breaks;
    for (std::size_t n = 0; n < scene_.phases.size(); ++n) {
      const Phase& phase = scene_.phases[n];
      if (!is_open_[n] || !is_of(phase, law)) continue;
      if (phase.form) form = *phase.form;
      if (phase.breaks) breaks = *phase.breaks;
    }
    for (PairRules<Number>* pair :
         {&rules.at(law.species_a, law.species_b), &rules.at(law.species_b, law.species_a)}) {
      pair->form = form;
      pair->breaks = breaks;
    }
  }

  const Scene& scene_;
  std::vector<Change> changes_;  ///< in their order
  std::vector<bool> is_open_;
  std::size_t done_ = 0;
};

struct phases {
  template <typename Number>
  static std::unique_ptr<EffectRules<Number>> make(const Scene& scene) {
    return std::make_unique<Phases<Number>>(scene);
  }
};

}  // namespace tps::check::effects
