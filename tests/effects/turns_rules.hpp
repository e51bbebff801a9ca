// Rules earliest and impulse, for quarter turns.
#pragma once

#include "tests/effects/turns.hpp"
#include "verify/trace_check/rules/outside_impulse.hpp"

namespace tps::check::effects {

template <typename Number>
class Turns final : public EffectRules<Number> {
 public:
  using W = Work<Number>;

  explicit Turns(const Scene& scene)
      : turns_(tps::effects::turns_of(scene)), quarters_(scene.particles.size(), 0) {}
  std::string_view effect() const override { return "turns"; }
  int rank() const override { return 25; }
  std::string what() const override { return "turn"; }
  std::uint64_t progress() const override { return done_; }

  std::optional<EventAhead> next(const Context<Number>&) const override {
    if (done_ == turns_.size()) return std::nullopt;
    return EventAhead{turns_[done_].at, turns_[done_].particle};
  }
  void pass(const Context<Number>&) override {
    quarters_[static_cast<std::size_t>(turns_[done_].particle)] += turns_[done_].left ? 1 : -1;
    ++done_;
  }

  /// The velocity is turned without rounding; Δv is rounded once, Δp = m Δv once more.
  void judge(const Context<Number>& c, const EventLine<Number>& event) const override {
    if (!judge_is_next(c, event, next(c))) return;
    const tps::effects::Turn& turn = turns_[done_];
    const Model<Number>& model = c.model;
    const std::int64_t quarters = quarters_[Model<Number>::at(event.i)] + (turn.left ? 1 : -1);
    judge_word(c, event, turn.left ? "left" : "right");
    judge_count(c, event, quarters);
    const Vec<W> before = widened<W>(model.flight(event.i).velocity);
    const W sign(turn.left ? 1 : -1);
    const Vec<W> right{{-sign * before[1], sign * before[0], before[2]}};
    const Vec<W> after = widened<W>(event.of(event.i)->velocity_after);
    c.tally.demand(Rule::impulse, after == right, [&](Finding& f) {
      const auto [is, should] = told_apart(after, right, model.scene.dimension);
      f.message = fmt::format("particle {} leaves with {}; a turn to the {} makes that {}", model.id(event.i),
                              is, turn.left ? "left" : "right", should);
    });
    const Vec<W> change = right - before;
    if (const auto* told = event.value_of("change")) {
      const auto* numbers = std::get_if<std::vector<Number>>(told);
      bool same = numbers != nullptr && numbers->size() == static_cast<std::size_t>(model.scene.dimension);
      for (std::size_t k = 0; same && k < numbers->size(); ++k) {
        using std::abs;
        same = abs(W((*numbers)[k]) - change[k]) <= c.scale() * c.u() * abs(change[k]);
      }
      c.tally.demand(Rule::impulse, same, [&](Finding& f) {
        f.message = fmt::format("\"change\" is not the {} by which the velocity changes",
                                shown(change, model.scene.dimension));
      });
    }
    if (!event.dp) return;
    const Vec<W> J = (W(1) / model.inverse_mass(event.i)) * change;
    const W error = W(2) * c.u() * largest(J) + model.precision.smallest;
    c.tally.demand(Rule::impulse, largest(widened<W>(*event.dp) - J) <= error * c.scale(), [&](Finding& f) {
      const auto [is, should] = told_apart(widened<W>(*event.dp), J, model.scene.dimension);
      f.message = fmt::format("the impulse of the turn is {}; m (v' - v) is {}", is, should);
    });
  }

 private:
  static void judge_word(const Context<Number>& c, const EventLine<Number>& event, std::string_view right) {
    const auto* told = event.value_of("towards");
    if (told == nullptr) return;
    const auto* word = std::get_if<std::string>(told);
    c.tally.demand(Rule::impulse, word != nullptr && *word == right, [&](Finding& f) {
      f.message = fmt::format("\"towards\" is not \"{}\", as the scene's next turn is", right);
    });
  }
  static void judge_count(const Context<Number>& c, const EventLine<Number>& event, std::int64_t right) {
    const auto* told = event.value_of("quarters");
    if (told == nullptr) return;
    const auto* count = std::get_if<std::int64_t>(told);
    c.tally.demand(Rule::impulse, count != nullptr && *count == right, [&](Finding& f) {
      f.message = fmt::format("\"quarters\" is not {}, which the turns so far add up to", right);
    });
  }

  std::vector<tps::effects::Turn> turns_;
  std::vector<std::int64_t> quarters_;  ///< by particle
  std::size_t done_ = 0;
};

struct turns {
  template <typename Number>
  static std::unique_ptr<EffectRules<Number>> make(const Scene& scene) {
    return std::make_unique<Turns<Number>>(scene);
  }
};

}  // namespace tps::check::effects
