// The textbook detector: every pair is asked for its next event once, and again when one of the two changes.
#pragma once

#include <algorithm>
#include <vector>

#include "reference/engine/detector.hpp"
#include "reference/engine/pair_predictor.hpp"

namespace tps {

template <typename Scalar, int D>
class AllPairs final : public Detector<Scalar, D> {
 public:
  using Event = PendingEvent<Scalar>;

  explicit AllPairs(const typename PairPredictor<Scalar, D>::Effects& effects) : predictor_(effects) {}

  /// N(N − 1)/2 pairs, once.
  void predict_all(World<Scalar, D>& world) override {
    queue_ = {};
    for (int i = 0; i < world.size(); ++i) {
      const auto asker = predictor_.asker(world, i, world.now);
      for (int j = i + 1; j < world.size(); ++j) keep(world, i, j, asker.earliest(j), world.now);
    }
  }

  /// The pairs of the touched particles, each once.
  void predict_touched(World<Scalar, D>& world, const std::vector<int>& touched) override {
    is_touched_.assign(world.particles.size(), false);
    for (const int i : touched) is_touched_[static_cast<std::size_t>(i)] = true;
    for (const int i : touched) {
      const auto asker = predictor_.asker(world, i, world.now);
      for (int j = 0; j < world.size(); ++j) {
        if (j == i || (j < i && is_touched_[static_cast<std::size_t>(j)])) continue;
        keep(world, std::min(i, j), std::max(i, j), asker.earliest(j), world.now);
      }
    }
  }

  Time<Scalar> earliest(World<Scalar, D>& world, const Time<Scalar>& limit) override {
    const Event* event = next(world, limit);
    return event != nullptr ? event->time : Time<Scalar>::never();
  }

  void collect(World<Scalar, D>& world, const Time<Scalar>& latest, std::vector<Event>& events) override {
    const auto first = static_cast<std::ptrdiff_t>(events.size());
    while (const Event* event = next(world, latest)) {
      if (latest < event->time) break;
      events.push_back(*event);
      queue_.pop();
    }
    std::for_each(events.begin() + first, events.end(), [&](const Event& event) { queue_.push(event); });
  }

 private:
  /// What is first in the queue. A look up to `limit` is done instead: the pair is asked anew.
  const Event* next(const World<Scalar, D>& world, const Time<Scalar>& limit) {
    while (true) {
      const Event* first = queue_.next([&](const Event& event) { return world.is_live(event); });
      if (first == nullptr || first->effect != kLook || limit < first->time) return first;
      const Event look = *first;
      queue_.pop();
      const int i = look.first;
      const int j = look.second;
      keep(world, i, j, predictor_.asker(world, i, look.time).earliest(j), look.time);
    }
  }

  /// The event of a pair, asked at t. In a periodic box the nearest image at t counts until another one can
  /// be met; what comes later is asked then.
  void keep(const World<Scalar, D>& world, int i, int j, const std::optional<Event>& event,
            const Time<Scalar>& t) {
    if (world.box && predictor_.can_meet(world, i, j)) {
      const Time<Scalar> look = world.box->holds_until(t, world.velocity(j) - world.velocity(i));
      if (look < Time<Scalar>::never() && !(event && event->time <= look)) {
        queue_.push(world.pending(look, Rank::collision, i, j, 0, kLook));
        return;
      }
    }
    if (event) queue_.push(*event);
  }

  static constexpr int kLook = -1;  ///< in the place of an effect

  PairPredictor<Scalar, D> predictor_;
  EventQueue<Scalar> queue_;
  std::vector<bool> is_touched_;
};

}  // namespace tps
