#include "properties/runs/hazards.hpp"

#include <cmath>

#include "properties/runs/implied_state.hpp"

namespace tps::properties::runs {
namespace {

Real start_distance(const Scene& scene, std::size_t i, std::size_t j) {
  Real square = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Real r = Real(scene.particles[j].position[k]) - Real(scene.particles[i].position[k]);
    square += r * r;
  }
  return std::sqrt(square);
}

bool is_at(Real distance, Real limit) {
  return std::abs(distance - limit) <= 1e-12L * limit;
}

void note_starts(const Scene& scene, const ImpliedState& start, std::set<std::string>& met) {
  for (std::size_t i = 0; i < scene.particles.size(); ++i) {
    for (std::size_t j = i + 1; j < scene.particles.size(); ++j) {
      const int a = static_cast<int>(i), b = static_cast<int>(j);
      const PairLaw* law = start.law(a, b);
      if (law == nullptr) continue;
      const Real distance = start_distance(scene, i, j);
      if (law->blocking && is_at(distance, law->blocking->distance)) met.insert("touching start");
      if (start.tethered(a, b) && is_at(distance, law->tethering->distance)) met.insert("taut start");
      const Real ratio = start.mass(a) / start.mass(b);
      if (std::isfinite(ratio) && (ratio > 1e6L || (ratio > 0 && ratio < 1e-6L))) met.insert("masses apart");
    }
  }
}

void note_collision(const ImpliedState& before, const TracedEvent& event, std::set<std::string>& met) {
  const int i = before.index_of(*event.i), j = before.index_of(*event.j);
  if (before.is_fixed(i) || before.is_fixed(j)) {
    met.insert(event.kind == "rebound" ? "wall" : "enclosure");
  }
  if (event.is_collision() && event.dp->isZero(0)) met.insert("no impulse");
  if (event.is_load() && event.members.size() > 2) met.insert("nested group");
  if (event.is_load() && std::isinf(before.body_mass(i) + before.body_mass(j))) met.insert("grounded group");
}

}  // namespace

const std::vector<HazardFloor>& hazard_floors() {
  static const std::vector<HazardFloor> floors = {
      {"tie", "two collisions of different pairs at one time", 150},
      {"touching start", "a pair starts at its inner limit", 150},
      {"taut start", "a tethered pair starts at its outer limit", 70},
      {"crowded", "ten events within 1e-6", 60},
      {"masses apart", "by a factor of more than a million", 80},
      {"no impulse", "a collision that rounding leaves without one", 1},
      {"rebound", "eq. (4) at the inner limit", 400},
      {"retract", "eq. (4) at the outer limit", 200},
      {"revolve", "eq. (5)", 300},
      {"break", "a tether breaks", 200},
      {"formed", "a tether forms", 80},
      {"drawn", "a rule draws a number", 150},
      {"wall", "a rebound of an infinite mass", 60},
      {"enclosure", "a pull by an infinite mass", 150},
      {"nested group", "a load of three or more particles", 120},
      {"grounded group", "a load against an infinite mass", 90},
      {"restitute", "a group is given back", 200},
      {"scheduled_impulse", "an impulse from outside", 150},
      {"late", "a collision when the clock's first number is as coarse as 2^-12", 30},
      {"phase_begin", "rules change", 100},
      {"phase_end", "rules change back", 50},
  };
  return floors;
}

std::set<std::string> hazards_met(const Scene& scene, const RunTrace& trace) {
  std::set<std::string> met;
  ImpliedState implied(scene, "double");
  note_starts(scene, implied, met);
  const TracedEvent* last = nullptr;
  for (std::size_t n = 0; n < trace.events.size(); ++n) {
    const TracedEvent& e = trace.events[n];
    met.insert(e.kind);
    if (e.tether == "formed") met.insert(e.tether);
    if (e.draw) met.insert("drawn");
    if (e.j) note_collision(implied, e, met);
    if (e.is_collision() && e.t.hi > 0x1p+39L) met.insert("late");
    if (last != nullptr && e.is_collision() && last->is_collision() && last->t == e.t &&
        (last->i != e.i || last->j != e.j))
      met.insert("tie");
    if (n >= 10 && elapsed(trace.events[n - 10].t, e.t) < 1e-6L) met.insert("crowded");
    last = &e;
    implied.apply(e);
  }
  return met;
}

}  // namespace tps::properties::runs
