// Which event a run takes next.
#pragma once

#include <algorithm>
#include <compare>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

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

/// Takes the next event out of the queue: the earliest by computed time; under certified timing the one that
/// is exactly the earliest on the stored states, exact ties by (rank, smaller particle, larger particle).
///
/// Where that one was computed later than an event that is still waiting, the latter keeps its computed time
/// but happens at the clock's: time never goes back. The choice is a function of the stored states and of
/// now.
template <typename Scalar, int D>
std::optional<PendingEvent<Scalar>> take_next(
    World<Scalar, D>& world, const std::vector<std::unique_ptr<Effect<Scalar, D>>>& effects) {
  using Event = PendingEvent<Scalar>;
  const auto next = [&] {
    return world.queue.next([&](const Event& event) { return world.is_live(event); });
  };
  const auto take = [&] {
    const Event event = *next();
    world.queue.pop();
    return event;
  };
  if (next() == nullptr) return std::nullopt;
  Event first = take();
  if (!world.timing.certified() || first.time == Time<Scalar>::never()) return first;

  const auto moment = [&](const Event& event) {
    if (event.rank != Rank::collision) return world.timing.known(event.time);
    const auto question = effects[world.index(event.effect)]->asks(world, event.first, event.second);
    return world.timing.moment(world.view(event.first, event.second), *question);
  };
  const Time<Scalar> latest = std::min(latest_rival(first.time), latest_finite<Scalar>());
  std::optional<Moment> earliest;
  std::vector<Event> later;
  while (next() != nullptr && next()->time <= latest) {
    Event rival = take();
    if (!earliest) earliest = moment(first);
    Moment of_rival = moment(rival);
    const std::weak_ordering order = world.timing.order(of_rival, *earliest);
    if (order < 0 || (order == 0 && rival.precedes_in_rank(first))) {
      std::swap(first, rival);
      std::swap(*earliest, of_rival);
    }
    later.push_back(rival);
  }
  for (const Event& event : later) world.queue.push(event);
  if (first.time < world.now) first.time = world.now;
  return first;
}

}  // namespace tps
