#include "properties/runs/allowance.hpp"

#include <algorithm>

namespace tps::properties {

Allowance::Allowance(const Replay& start, Real roundoff) : u_(roundoff) {
  for (int i = 0; i < start.size(); ++i)
    largest_.push_back({start.flight(i).position.norm(), start.flight(i).velocity.norm()});
}

void Allowance::note(const Replay& before, const TracedEvent& event) {
  for (int i = 0; i < before.size(); ++i) {
    Largest& l = largest_[static_cast<std::size_t>(i)];
    l.coordinate = std::max(l.coordinate, before.position(i, event.t).norm());
    const auto post = event.post.find(before.id_of(i));
    if (post != event.post.end()) l.speed = std::max(l.speed, post->second.velocity.norm());
    l.speed = std::max(l.speed, before.flight(i).velocity.norm());
  }
  if (event.i && event.j) ++events_[std::minmax(before.index_of(*event.i), before.index_of(*event.j))];
}

Real Allowance::distance(int i, int j, Real limit, const Instant& t) const {
  const auto found = events_.find(std::minmax(i, j));
  const Real events = found == events_.end() ? 0 : found->second;
  const Largest &a = largest_[static_cast<std::size_t>(i)], &b = largest_[static_cast<std::size_t>(j)];
  return u_ * kSpare *
         (16 * (1 + events) * (a.coordinate + b.coordinate + limit) + 64 * (a.speed + b.speed) * t.hi);
}

Real Allowance::normal_speed(int i, int j, Real limit, const Instant& t, Real v) const {
  return v * (distance(i, j, limit, t) / limit + 16 * u_);
}

}  // namespace tps::properties
