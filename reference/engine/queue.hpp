// The events that lie ahead, in the one order that a run takes them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <tuple>
#include <vector>

#include "reference/engine/clock.hpp"

namespace tps {

/// Which of several events at one computed time comes first (semantics §6). What an effect knows in advance
/// has a rank of its own between restitution and wall, which stands in the effect's file.
enum class Rank : std::uint8_t { restitution = 0, wall = 60, collision = 70 };

/// An event that will happen unless one of its particles changes first.
template <typename Scalar>
struct PendingEvent {
  Time<Scalar> time;
  Rank rank;
  int first;   ///< smaller particle index; −1 where the event concerns no particle
  int second;  ///< larger particle index; equal to `first` for events of one particle or body
  int detail;  ///< meaning of the effect's own: which limit, which scheduled impulse
  int effect;  ///< who responds: an index into the simulation's effects
  std::uint32_t first_revision, second_revision;  ///< of the particles when this was predicted

  friend bool operator<(const PendingEvent& a, const PendingEvent& b) {
    return a.time == b.time ? a.precedes_in_rank(b) : a.time < b.time;
  }
  /// The order of events at one time.
  bool precedes_in_rank(const PendingEvent& other) const {
    return std::tie(rank, first, second, detail) <
           std::tie(other.rank, other.first, other.second, other.detail);
  }
};

/// A binary heap of pending events. A particle that changes leaves its old events behind; they are dropped
/// when they surface, and all at once when they outnumber the live ones.
template <typename Scalar>
class EventQueue {
 public:
  using Event = PendingEvent<Scalar>;

  void push(const Event& event) {
    heap_.push_back(event);
    std::push_heap(heap_.begin(), heap_.end(), later);
  }

  /// The earliest event for which is_live(event) holds, or null; stays in the queue until pop().
  template <typename IsLive>
  const Event* next(IsLive is_live) {
    if (heap_.size() > limit_) drop_stale(is_live);
    while (!heap_.empty() && !is_live(heap_.front())) pop();
    return heap_.empty() ? nullptr : &heap_.front();
  }

  void pop() {
    std::pop_heap(heap_.begin(), heap_.end(), later);
    heap_.pop_back();
  }

 private:
  static bool later(const Event& a, const Event& b) { return b < a; }

  template <typename IsLive>
  void drop_stale(IsLive is_live) {
    std::erase_if(heap_, std::not_fn(is_live));
    std::make_heap(heap_.begin(), heap_.end(), later);
    limit_ = std::max<std::size_t>(kSmallest, 2 * heap_.size());
  }

  static constexpr std::size_t kSmallest = 4096;
  std::vector<Event> heap_;
  std::size_t limit_ = kSmallest;
};

}  // namespace tps
