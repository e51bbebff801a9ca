// Rules earliest and impulse, for gravity: impulses m g δ on every finite mass.
#pragma once

#include "verify/trace_check/rules/outside_impulse.hpp"

namespace tps::check::effects {

template <typename Number>
class GravityKicks final : public EffectRules<Number> {
 public:
  using W = Work<Number>;

  explicit GravityKicks(const Scene& scene) : gravity_(scene.gravity) {}
  std::string_view effect() const override { return "gravity"; }
  int rank() const override { return 30; }
  std::string what() const override { return "gravity"; }
  std::uint64_t progress() const override { return done_; }
  bool moves_everybody() const override { return true; }

  std::optional<EventAhead> next(const Context<Number>&) const override {
    if (!gravity_) return std::nullopt;
    return EventAhead{static_cast<double>(done_) * gravity_->every};
  }
  void pass(const Context<Number>&) override { ++done_; }
  void pass_over(const Context<Number>&, std::uint64_t count) override {
    if (count > 0 && !gravity_) throw std::out_of_range("the scene has no gravity");
    done_ += count;
  }

  /// At its times, with the scene's change of velocity rounded once.
  void judge(const Context<Number>& c, const EventLine<Number>& event) const override {
    c.tally.demand(Rule::earliest, gravity_.has_value(),
                   [](Finding& f) { f.message = "the scene has no gravity"; });
    if (!gravity_) return;
    judge_scheduled_time(c, event, next(c)->at, what());
    if (!event.dv) return;
    const Vec<W> right = change(c);
    const Vec<W> found = widened<W>(*event.dv);
    const W error = c.u() * largest(right) + c.model.precision.smallest;
    c.tally.demand(Rule::impulse, largest(found - right) <= error * c.scale(), [&](Finding& f) {
      const auto [is, should] = told_apart(found, right, c.model.scene.dimension);
      f.message = fmt::format("gravity changes velocities by {}, but the scene has {}", is, should);
    });
  }

  /// Velocities are in no line: the sum v + Δv, rounded once. Bodies that are grounded keep theirs.
  void follow(const Context<Number>& c, const EventLine<Number>& event,
              const typename EffectRules<Number>::BeginFlight& begin_flight) override {
    const Model<Number>& model = c.model;
    Vec<Number> added;
    if (event.dv) {
      added = *event.dv;
    } else if (gravity_) {
      added = stored_change(c);
    }
    for (int i = 0; i < model.size(); ++i) {
      if (model.fixed(i)) continue;
      Vec<Number> velocity = model.flight(i).velocity;
      if (model.inverse_mass(i) != W(0)) {
        for (std::size_t k = 0; k < 3; ++k)
          velocity[k] = sum_in_scalar(velocity[k], added[k], model.precision);
      }
      begin_flight(i, velocity);
    }
  }

 private:
  /// What the next event adds to velocities: g δ, at the first one half of it. REQUIRES gravity.
  Vec<W> change(const Context<Number>& c) const {
    const W every = W(stored<Number>(gravity_->every, c.model.precision));
    const Vec<W> whole = every * stored_vector(c, gravity_->acceleration);
    return done_ == 0 ? W(0.5) * whole : whole;
  }

  /// The same as a run stores it: the product rounded once to the scalar, half of it exactly.
  Vec<Number> stored_change(const Context<Number>& c) const {
    const Precision<Number>& precision = c.model.precision;
    const Number every = stored<Number>(gravity_->every, precision);
    Vec<Number> added;
    for (std::size_t k = 0; k < 3; ++k) {
      added[k] = product_in_scalar(every, stored<Number>(gravity_->acceleration[k], precision), precision);
      if (done_ == 0) added[k] /= Number(2);
    }
    return added;
  }

  const std::optional<Gravity> gravity_;
  std::uint64_t done_ = 0;
};

struct gravity {
  template <typename Number>
  static std::unique_ptr<EffectRules<Number>> make(const Scene& scene) {
    return std::make_unique<GravityKicks<Number>>(scene);
  }
};

}  // namespace tps::check::effects
