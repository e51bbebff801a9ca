#include "verify/trace_check/agenda.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

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

std::vector<int> Agenda::due(double t) {
  std::vector<int> all = std::exchange(open_, {});
  while (!waiting_.empty() && waiting_.top().t <= t) {
    const Waiting next = waiting_.top();
    waiting_.pop();
    if (next.number == number_[static_cast<std::size_t>(next.partner)]) all.push_back(next.partner);
  }
  std::sort(all.begin(), all.end());
  for (const int i : all) place_[static_cast<std::size_t>(i)] = Place::out;
  return all;
}

void Agenda::put_off(int partner, double t) {
  const auto n = static_cast<std::size_t>(partner);
  ++number_[n];
  if (!(t > -HUGE_VAL)) {
    place_[n] = Place::open;
    open_.push_back(partner);
    return;
  }
  place_[n] = Place::waiting;
  if (t < HUGE_VAL) waiting_.push({t, partner, number_[n]});
}

}  // namespace tps::check
