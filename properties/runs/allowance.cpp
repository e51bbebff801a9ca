#include "properties/runs/allowance.hpp"

#include <algorithm>

namespace tps::properties::runs {

Allowance::Allowance(const ImpliedState& start, Real roundoff) : u_(roundoff) {
  for (int i = 0; i < start.size(); ++i)
    largest_.push_back({start.flight(i).position.norm(), start.flight(i).velocity.norm()});
}

void Allowance::fly(const ImpliedState& implied, const Instant& t) {
  for (int i = 0; i < implied.size(); ++i) {
    Largest& l = largest_[static_cast<std::size_t>(i)];
    l.speed = std::max(l.speed, implied.flight(i).velocity.norm());
    l.path += l.speed * elapsed(now_, t);
    l.coordinate = std::max(l.coordinate, implied.position(i, t).norm());
  }
  now_ = t;
}

void Allowance::note(const ImpliedState& before, const TracedEvent& event) {
  fly(before, event.t);
  for (const auto& [id, state] : event.post) {
    Largest& l = largest_[static_cast<std::size_t>(before.index_of(id))];
    l.speed = std::max(l.speed, state.velocity.norm());
  }
  if (event.i && event.j) ++events_[std::minmax(before.index_of(*event.i), before.index_of(*event.j))];
}

Real Allowance::distance(int i, int j, Real limit) const {
  const auto found = events_.find(std::minmax(i, j));
  const Real events = found == events_.end() ? 0 : found->second;
  const Largest &a = largest_[static_cast<std::size_t>(i)], &b = largest_[static_cast<std::size_t>(j)];
  const Real landing = 16 * (1 + events) * (a.coordinate + b.coordinate + limit);
  return u_ * kSpare * (landing + 64 * (a.path + b.path));
}

Real Allowance::normal_speed(int i, int j, Real limit, Real v) const {
  return v * (distance(i, j, limit) / limit + 16 * u_);
}

}  // namespace tps::properties::runs
