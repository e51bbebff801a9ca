// What lies between events: straight flight, the limits, and that no event is missed, early or repeated.
#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "properties/runs/allowance.hpp"
#include "properties/runs/collision.hpp"
#include "properties/runs/laws.hpp"

namespace tps::properties::runs {
namespace {

std::string pair_name(const ImpliedState& implied, int i, int j) {
  return std::to_string(implied.id_of(i)) + " and " + std::to_string(implied.id_of(j));
}

/// Least and largest distance of a pair between two instants: the vertex of the quadratic where it lies
/// between, else the ends.
std::pair<Real, Real> distances_between(const ImpliedState& implied, int i, int j, const Instant& from,
                                        const Instant& to) {
  const Point first = implied.position(j, from) - implied.position(i, from);
  const Point last = implied.position(j, to) - implied.position(i, to);
  const Point v = implied.flight(j).velocity - implied.flight(i).velocity;
  Real least = std::min(first.norm(), last.norm());
  const Real at_vertex = v.isZero(0) ? 0 : -first.dot(v) / v.squaredNorm();
  if (at_vertex > 0 && at_vertex < elapsed(from, to)) least = std::min(least, (first + v * at_vertex).norm());
  return {least, std::max(first.norm(), last.norm())};
}

/// A pair that is beyond one of its limits between two instants.
std::optional<std::string> bound_broken(const ImpliedState& implied, const Allowance& allowance,
                                        const Instant& from, const Instant& to) {
  for (int i = 0; i < implied.size(); ++i) {
    for (int j = i + 1; j < implied.size(); ++j) {
      const PairLaw* law = implied.law(i, j);
      if (law == nullptr) continue;
      const auto [least, most] = distances_between(implied, i, j, from, to);
      if (law->blocking) {
        const Real limit = implied.stored(law->blocking->distance);
        if (auto fault = beyond(pair_name(implied, i, j) + " within their inner limit by", limit - least,
                                allowance.distance(i, j, limit)))
          return fault;
      }
      if (implied.tethered(i, j)) {
        const Real limit = implied.stored(law->tethering->distance);
        if (auto fault = beyond(pair_name(implied, i, j) + " past their outer limit by", most - limit,
                                allowance.distance(i, j, limit)))
          return fault;
      }
    }
  }
  return std::nullopt;
}

/// In float the inward part of a revolution at 1e-6 degrees, 1.7e-8 of it, is below the rounding of the
/// other: the pair is left moving across, and can leave (docs/properties_runs.md).
bool angles_are_lost(const Scene& scene, const Simulator& simulator) {
  return simulator.scalar() == "float" && std::ranges::any_of(scene.pairs, [](const PairLaw& law) {
           return law.tethering && law.tethering->theta_revolve_deg < 1e-3;
         });
}

RunVerdict keeps_distances(const Scene& scene, Simulator& simulator) {
  if (angles_are_lost(scene, simulator)) return RunVerdict::not_asked();
  const RunTrace trace = simulator.run(scene);
  ImpliedState implied(scene, simulator.scalar());
  Allowance allowance(implied, simulator.roundoff());
  Instant now;
  for (const TracedEvent& event : trace.events) {
    allowance.note(implied, event);
    if (auto fault = bound_broken(implied, allowance, now, event.t))
      return RunVerdict::broken("before event " + std::to_string(event.k) + ": " + *fault);
    implied.apply(event);
    now = event.t;
  }
  allowance.fly(implied, trace.end_time);
  return RunVerdict::of(bound_broken(implied, allowance, now, trace.end_time));
}

/// A collision happens at its limit, to pairs that move beyond it.
std::optional<std::string> not_due(const ImpliedState& before, const Allowance& allowance,
                                   const TracedEvent& event) {
  const Collided c = collided(before, event);
  const PairLaw* law = before.law(c.i, c.j);
  if (law == nullptr) return "a collision of two particles that do not interact";
  const bool inner = event.kind == "rebound";
  if (inner ? !law->blocking.has_value() : !before.tethered(c.i, c.j))
    return inner ? "a rebound of a pair without blocking" : "a pull of a pair that is not tethered";
  const Real limit = before.stored(inner ? law->blocking->distance : law->tethering->distance);
  if (auto fault = beyond("distance beside the limit", std::abs(c.distance - limit),
                          allowance.distance(c.i, c.j, limit)))
    return fault;
  return beyond(inner ? "receding at" : "approaching at", inner ? c.v_n : -c.v_n,
                allowance.normal_speed(c.i, c.j, limit, c.v_AB.norm()));
}

RunVerdict collides_when_due(const Scene& scene, Simulator& simulator) {
  ImpliedState start(scene, simulator.scalar());
  Allowance allowance(start, simulator.roundoff());
  return RunVerdict::of(
      first_fault(scene, simulator,
                  [&](const ImpliedState& before, const TracedEvent& event) -> std::optional<std::string> {
                    allowance.note(before, event);
                    if (!event.is_collision() && event.kind != "break") return std::nullopt;
                    return not_due(before, allowance, event);
                  }));
}

/// The place of a particle at an event, which the run has rounded: elapsed, product and sum, twice where it
/// was carried along in a group. The velocity is the one it was left with, bit for bit.
std::optional<std::string> not_in_flight(const ImpliedState& before, const TracedEvent& event, Real u) {
  for (const auto& [id, state] : event.pre) {
    const int i = before.index_of(id);
    const Flight& f = before.flight(i);
    const std::string name = "particle " + std::to_string(id);
    if (state.velocity != f.velocity) return name + " has changed its velocity since its last event";
    if (event.post.at(id).position != state.position) return name + " jumps at the event";
    const Point expected = before.position(i, event.t);
    const Real rounding =
        u * kSpare * (4 * f.velocity.norm() * elapsed(f.clock, event.t) + 2 * expected.norm());
    if (auto fault =
            beyond(name + " beside its straight path", (state.position - expected).norm(), 2 * rounding))
      return fault;
  }
  return std::nullopt;
}

/// dt is the difference of two sums hi + lo, rounded once where their los do not cancel against an ulp of hi;
/// there by 2 u² t, which is what a time is known to.
RunVerdict flies_straight(const Scene& scene, Simulator& simulator) {
  const Real u = simulator.roundoff();
  Instant last;
  return RunVerdict::of(
      first_fault(scene, simulator,
                  [&](const ImpliedState& before, const TracedEvent& event) -> std::optional<std::string> {
                    const Real dt = elapsed(last, event.t);
                    last = event.t;
                    if (dt < 0) return "time goes back";
                    if (auto fault = beyond("dt beside the difference of times", std::abs(event.dt - dt),
                                            u * kSpare * (dt + 4 * u * event.t.hi)))
                      return fault;
                    return not_in_flight(before, event, u);
                  }));
}

/// What a pair looked like after it had responded at a limit.
struct Left {
  Point v_i, v_j;
  Instant t;
};

RunVerdict responds_once(const Scene& scene, Simulator& simulator) {
  std::map<std::tuple<int, int, bool>, Left> responded;
  return RunVerdict::of(first_fault(
      scene, simulator,
      [&](const ImpliedState& before, const TracedEvent& event) -> std::optional<std::string> {
        if (!event.is_collision()) return std::nullopt;
        const bool inner = event.kind == "rebound";
        const auto key = std::make_tuple(before.index_of(*event.i), before.index_of(*event.j), inner);
        const TracedState &i = event.pre.at(*event.i), &j = event.pre.at(*event.j);
        const auto last = responded.find(key);
        const bool again =
            last != responded.end() && last->second.v_i == i.velocity && last->second.v_j == j.velocity;
        if (again && (inner || last->second.t == event.t))
          return "the pair responds again though nothing has changed its velocities";
        responded[key] = {event.post.at(*event.i).velocity, event.post.at(*event.j).velocity, event.t};
        return std::nullopt;
      }));
}

/// Impulses and phases from outside, in the order of the scene's times.
RunVerdict keeps_the_schedule(const Scene& scene, Simulator& simulator) {
  const RunTrace trace = simulator.run(scene);
  const ImpliedState start(scene, simulator.scalar());
  std::vector<Real> impulses, phases;
  for (const ScheduledImpulse& impulse : scene.impulses) impulses.push_back(start.stored(impulse.at));
  for (const Phase& phase : scene.phases) {
    phases.push_back(start.stored(phase.from));
    if (std::isfinite(phase.until)) phases.push_back(start.stored(phase.until));
  }
  for (auto [times, is_one] :
       {std::pair{impulses, +[](const TracedEvent& e) { return e.kind == "scheduled_impulse"; }},
        std::pair{phases, +[](const TracedEvent& e) { return e.phase >= 0; }}}) {
    std::sort(times.begin(), times.end());
    std::size_t next = 0;
    for (const TracedEvent& event : trace.events) {
      if (!is_one(event)) continue;
      if (next == times.size())
        return RunVerdict::broken("event " + std::to_string(event.k) + " is on no schedule");
      if (event.t != Instant{times[next], 0})
        return RunVerdict::broken("event " + std::to_string(event.k) + " is not at its scheduled time");
      ++next;
    }
    // A run that ends at its duration has had the events of that time.
    const bool passed =
        next < times.size() &&
        (times[next] < trace.end_time.hi || (trace.end == "duration" && times[next] == trace.end_time.hi));
    if (passed) return RunVerdict::broken("the run has passed a scheduled time without its event");
  }
  return {};
}

}  // namespace

std::vector<RunLaw> flight_laws() {
  return {
      {4, "Flight",
       "Between events particles fly straight; at one they stay in place; velocities change at events only, "
       "and dt is the difference of times.",
       "docs/engine.md", of({}), flies_straight},
      {5, "Distances",
       "No pair is nearer than its inner limit or, tethered, farther apart than its outer one, at any "
       "time of a run: whole flights, for all pairs, so no event is late or missing.",
       "docs/engine.md", of({}), keeps_distances, true},
      {6, "Due",
       "A collision happens at its pair's limit and only to a pair that moves beyond it: no event is early.",
       "docs/eq2.md", of({}), collides_when_due, true},
      {7, "Once",
       "A pair that has responded at a limit does not respond there again before one of its velocities has "
       "changed; at the outer limit, before time has passed.",
       "docs/engine.md", of({}), responds_once, true},
      {8, "Schedule", "Scheduled impulses and phases happen at exactly their times, each once.",
       "docs/scene.md", of({}), keeps_the_schedule},
  };
}

}  // namespace tps::properties::runs
