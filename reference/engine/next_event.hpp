// Which event a run takes next.
#pragma once

#include <algorithm>
#include <compare>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "reference/engine/detector.hpp"
#include "reference/engine/effect.hpp"
#include "reference/engine/world.hpp"

namespace tps {

/// The latest computed time at which an event can in fact be before one computed for `earliest`.
///
/// A certified time t from `start` ≥ 0 is rounded once and added once: its event's computed time T misses the
/// exact one by at most u t + 2u² T plus half the smallest number, less than 1.1 u T + that. Two of them
/// leave 2.2 u T, and 8u T pays for T of the other one, for the rounding here and for the spare.
template <typename Scalar>
Time<Scalar> latest_rival(const Time<Scalar>& earliest) {
  using Limits = std::numeric_limits<Scalar>;
  return after(earliest, Scalar(4 * (Limits::epsilon() * earliest.hi + Limits::denorm_min())));
}

template <typename Scalar>
Time<Scalar> latest_finite() {
  return {std::numeric_limits<Scalar>::max(), Scalar(0)};
}

/// What a run does next.
template <typename Scalar>
struct ChosenEvent {
  Time<Scalar> time;  ///< of the event; where there is none, nothing happens before this time
  std::optional<PendingEvent<Scalar>> event;
};

/// Chooses the next event among those that the detector and the queue have ahead.
template <typename Scalar, int D>
class NextEventChoice {
 public:
  using Event = PendingEvent<Scalar>;
  using Effects = std::vector<std::unique_ptr<Effect<Scalar, D>>>;

  /// The earliest event by computed time; under certified timing the one that is exactly the earliest on the
  /// stored states, exact ties by (rank, smaller particle, larger particle). None where there is none up to
  /// `horizon`. An event of the queue is taken out of it. Throws OutOfRange.
  ///
  /// Where the chosen one was computed later than an event that is still waiting, the latter keeps its
  /// computed time but happens at the clock's: time never goes back. The choice is a function of the stored
  /// states and of now.
  ChosenEvent<Scalar> take(World<Scalar, D>& world, Detector<Scalar, D>& detector, const Effects& effects,
                           const Time<Scalar>& horizon) {
    const Time<Scalar> earliest = earliest_time(world, detector, horizon);
    if (horizon < earliest) return {earliest, std::nullopt};
    const bool exact = world.timing.certified() && earliest < Time<Scalar>::never();
    const Time<Scalar> latest = exact ? std::min(latest_rival(earliest), latest_finite<Scalar>()) : earliest;
    candidates_.clear();
    detector.collect(world, latest, candidates_);
    const std::size_t of_pairs = candidates_.size();
    while (const Event* known = next_known(world)) {
      if (latest < known->time) break;
      candidates_.push_back(*known);
      world.queue.pop();
    }
    if (candidates_.empty()) return {Time<Scalar>::never(), std::nullopt};
    const std::size_t chosen = exact ? exactly_first(world, effects) : computed_first();
    for (std::size_t n = of_pairs; n < candidates_.size(); ++n) {
      if (n != chosen) world.queue.push(candidates_[n]);
    }
    Event first = candidates_[chosen];
    if (exact && first.time < world.now) first.time = world.now;
    return {first.time, first};
  }

 private:
  static const Event* next_known(World<Scalar, D>& world) {
    return world.queue.next([&](const Event& event) { return world.is_live(event); });
  }

  static Time<Scalar> earliest_time(World<Scalar, D>& world, Detector<Scalar, D>& detector,
                                    const Time<Scalar>& horizon) {
    const Event* known = next_known(world);
    if (known == nullptr) return detector.earliest(world, horizon);
    return std::min(known->time, detector.earliest(world, std::min(known->time, horizon)));
  }

  std::size_t computed_first() const {
    return static_cast<std::size_t>(std::min_element(candidates_.begin(), candidates_.end()) -
                                    candidates_.begin());
  }

  std::size_t exactly_first(const World<Scalar, D>& world, const Effects& effects) const {
    if (candidates_.size() == 1) return 0;
    const auto moment = [&](const Event& event) {
      const Effect<Scalar, D>& effect = *effects[world.index(event.effect)];
      if (event.rank != Rank::collision) return effect.moment(world, event);
      const auto question = effect.asks(world, event.first, event.second);
      if (world.box)
        return world.timing.moment(world.imaged_view(event.first, event.second, event.time), *question);
      return world.timing.moment(world.view(event.first, event.second), *question);
    };
    std::size_t first = 0;
    Moment earliest = moment(candidates_.front());
    for (std::size_t n = 1; n < candidates_.size(); ++n) {
      const Moment rival = moment(candidates_[n]);
      const std::weak_ordering order = world.timing.order(rival, earliest);
      if (order > 0 || (order == 0 && !candidates_[n].precedes_in_rank(candidates_[first]))) continue;
      first = n;
      earliest = rival;
    }
    return first;
  }

  std::vector<Event> candidates_;
};

}  // namespace tps
