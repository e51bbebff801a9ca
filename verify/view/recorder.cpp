#include "verify/view/recorder.hpp"

#include <algorithm>
#include <limits>

namespace tps::view {
namespace {

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

std::size_t at(int n) {
  return static_cast<std::size_t>(n);
}

}  // namespace

Recorder::Recorder(Playback& playback)
    : playback_(playback), bodies_(playback.scene), change_of_event_(playback.scene.particles.size(), kNone) {
  for (const Particle& p : playback.scene.particles)
    now_.push_back({0, static_cast<int>(now_.size()), -1, p.position, p.velocity});
}

void Recorder::begin(double t, check::Kind kind, std::uint64_t line, std::uint64_t k) {
  for (const int particle : in_event_) change_of_event_[at(particle)] = kNone;
  in_event_.clear();
  // A broken trace may go back; what is played may not.
  const double later = std::max(t, t_);
  Event event;
  event.t = later;
  event.dt = later - t_;
  event.number = ++playback_.all_events;
  event.k = k;
  event.line = line;
  event.kind = kind;
  event.first_change = playback_.changes.size();
  playback_.events.push_back(event);
  playback_.t_end = t_ = later;
}

Change& Recorder::changed(int particle) {
  std::size_t& place = change_of_event_[at(particle)];
  if (place == kNone) {
    Change& now = now_[at(particle)];
    for (std::size_t k = 0; k < 3; ++k) now.position[k] += now.velocity[k] * (t_ - now.t);
    now.t = t_;
    place = playback_.changes.size();
    playback_.changes.push_back(now);
    in_event_.push_back(particle);
  }
  return playback_.changes[place];
}

void Recorder::put(int particle, const Coordinates& position) {
  changed(particle).position = position;
  now_[at(particle)].position = position;
}

void Recorder::set_velocity(int particle, const Coordinates& velocity) {
  changed(particle).velocity = velocity;
  now_[at(particle)].velocity = velocity;
}

void Recorder::everybody_gains(const Coordinates& dv) {
  for (int n = 0; n < static_cast<int>(now_.size()); ++n) {
    if (bodies_.infinite(n) || bodies_.grounded(n)) continue;
    Coordinates velocity = now_[at(n)].velocity;
    for (std::size_t k = 0; k < 3; ++k) velocity[k] += dv[k];
    set_velocity(n, velocity);
  }
}

void Recorder::follow_bodies(const std::vector<int>& members) {
  Event& event = playback_.events.back();
  std::vector<int> touched;
  if (!members.empty()) {
    event.load = true;
    bodies_.load(event.i, event.j, members);
    touched = members;
    const int first = bodies_.infinite(event.i) ? event.j : event.i;
    for (const int m : members) {
      if (change_of_event_[at(m)] == kNone) set_velocity(m, now_[at(first)].velocity);
    }
  } else if (event.kind == check::Kind::restitute) {
    const auto sides = bodies_.part(event.i, event.j);
    for (std::size_t s = 0; s < 2; ++s) {
      const Coordinates velocity = now_[at(s == 0 ? event.i : event.j)].velocity;
      for (const int m : sides[s]) {
        if (change_of_event_[at(m)] == kNone) set_velocity(m, velocity);
        touched.push_back(m);
      }
    }
  }
  for (const int m : touched) changed(m).body = now_[at(m)].body = bodies_.number(m);
}

void Recorder::follow_tether() {
  const Event& event = playback_.events.back();
  if (event.formed || event.broken) playback_.tethers.push_back({event.t, event.i, event.j, event.formed});
}

}  // namespace tps::view
