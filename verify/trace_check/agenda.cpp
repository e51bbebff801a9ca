#include "verify/trace_check/agenda.hpp"

#include <algorithm>
#include <cmath>

namespace tps::check {

Agenda::Agenda(const std::vector<int>& partners, std::size_t particles)
    : place_(particles, Place::no_partner), number_(particles, 0), open_(partners) {
  for (const int i : partners) place_[static_cast<std::size_t>(i)] = Place::open;
}

void Agenda::begins_flight(int i) {
  Place& place = place_[static_cast<std::size_t>(i)];
  if (place != Place::waiting) return;
  place = Place::open;
  ++number_[static_cast<std::size_t>(i)];
  open_.push_back(i);
}

const std::vector<Agenda::Due>& Agenda::due(double t) {
  due_.clear();
  for (const int i : open_) due_.push_back({i, false});
  open_.clear();
  while (!waiting_.empty() && waiting_.top().t <= t) {
    const Waiting next = waiting_.top();
    waiting_.pop();
    if (next.number == number_[static_cast<std::size_t>(next.partner)])
      due_.push_back({next.partner, next.roughly});
  }
  std::sort(due_.begin(), due_.end(), [](const Due& a, const Due& b) { return a.partner < b.partner; });
  for (const Due& each : due_) place_[static_cast<std::size_t>(each.partner)] = Place::out;
  return due_;
}

void Agenda::put_off(int partner, double t, bool roughly) {
  const auto n = static_cast<std::size_t>(partner);
  ++number_[n];
  if (!(t > -HUGE_VAL)) {
    place_[n] = Place::open;
    open_.push_back(partner);
    return;
  }
  place_[n] = Place::waiting;
  if (t < HUGE_VAL) waiting_.push({t, partner, number_[n], roughly});
}

}  // namespace tps::check
