// What random impulses and the thermostat have in common for the check: kicks on single particles at times
// that the scene's seed knows in advance.
#pragma once

#include <map>
#include <set>
#include <utility>

#include "reference/scene/random_kicks.hpp"
#include "verify/trace_check/rules/outside_impulse.hpp"

namespace tps::check {

/// Follows the draws of the scene's seed by our generator, which is the reference's own code: what a trace
/// says of them is judged as far as that generator is right, which its statistics and known answers test. By
/// draws of another generator times and sizes are taken as given.
template <typename Number>
class RandomTimes : public EffectRules<Number> {
 public:
  std::optional<EventAhead> next(const Context<Number>& c) const override {
    if (!c.own_draws || waiting_.empty()) return std::nullopt;
    const auto [at, particle] = *waiting_.begin();
    return EventAhead{at, particle, times_.at(particle).done() + 1};
  }
  void pass(const Context<Number>&) override {
    ++passed_;
    const int particle = waiting_.begin()->second;
    waiting_.erase(waiting_.begin());
    PoissonTimes& times = times_.at(particle);
    times.advance();
    waiting_.emplace(times.next(), particle);
  }

  void judge(const Context<Number>& c, const EventLine<Number>& event) const override {
    if (c.own_draws) {
      const std::optional<EventAhead> ahead = next(c);
      return judge_kick(c, event, ahead, [&] { return impulse(c, *ahead); });
    }
    c.tally.not_judged(Rule::earliest, "times and sizes of random impulses are taken as given");
    if (event.dp) judge_pushed(c, event, widened<Work<Number>>(*event.dp));
  }
  /// Kicks of a particle are counted where draws are, by purpose and id.
  void follow(const Context<Number>& c, const EventLine<Number>& event,
              const typename EffectRules<Number>::BeginFlight&) override {
    ++c.model.draws[{static_cast<int>(purpose_), c.model.id(event.i), c.model.id(event.i)}];
  }
  /// Each takes its time: the times are sums.
  std::uint64_t events_in(const Context<Number>& c, const StateData&) const override {
    return c.own_draws ? happened(c) : 0;
  }
  bool is_whole_in_state(const Context<Number>& c) const override {
    return passed_ == (c.own_draws ? happened(c) : 0);
  }
  int waits_for(const EventLine<Number>& event) const override { return event.i; }

 protected:
  explicit RandomTimes(Purpose purpose) : purpose_(purpose) {}
  /// Particles whose species have a mean waiting time.
  template <typename Tau>
  void add_particles(const Scene& scene, Purpose wait, Tau tau_of) {
    for (std::size_t i = 0; i < scene.particles.size(); ++i) {
      const std::optional<double> tau =
          tau_of(scene.species[static_cast<std::size_t>(scene.particles[i].species)]);
      if (!tau) continue;
      const PoissonTimes times(scene.seed, wait, scene.particles[i].id, *tau);
      times_.emplace(static_cast<int>(i), times);
      waiting_.emplace(times.next(), static_cast<int>(i));
    }
  }
  virtual KickImpulse<Number> impulse(const Context<Number>&, const EventAhead&) const = 0;

 private:
  /// Its events so far, in lines or by a state.
  std::uint64_t happened(const Context<Number>& c) const {
    std::uint64_t count = 0;
    for (const KindRow& known : kinds()) {
      if (known.effect == this->effect()) count += c.model.kinds[static_cast<std::size_t>(known.kind)];
    }
    return count;
  }

  Purpose purpose_;
  std::uint64_t passed_ = 0;
  std::map<int, PoissonTimes> times_;         ///< by particle
  std::set<std::pair<double, int>> waiting_;  ///< (time, particle)
};

}  // namespace tps::check
