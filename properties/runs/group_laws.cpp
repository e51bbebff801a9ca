// Groups: loads, expiry, unwinding (semantics §4), judged against the implied state's own nested sets.
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "properties/runs/collision.hpp"
#include "properties/runs/laws.hpp"

namespace tps::properties::runs {
namespace {

std::string name_of(const ImpliedState& implied, const std::set<int>& particles) {
  std::string text;
  for (const int p : particles) text += (text.empty() ? "{" : ", ") + std::to_string(implied.id_of(p));
  return text + "}";
}

/// A load unites the two bodies and nobody else; an infinite mass joins none.
std::optional<std::string> unites_wrongly(const ImpliedState& before, const TracedEvent& event) {
  const int i = before.index_of(*event.i), j = before.index_of(*event.j);
  if (before.together(i, j)) return "two particles of one group collide";
  std::set<int> united;
  for (const int side : {i, j}) {
    if (!before.is_fixed(side)) united.merge(before.with(side));
  }
  std::set<int> members;
  for (const std::int32_t id : event.members) members.insert(before.index_of(id));
  if (!std::is_sorted(event.members.begin(), event.members.end())) return "members are not ascending";
  if (members != united)
    return "members are " + name_of(before, members) + ", but the bodies are " + name_of(before, united);
  return std::nullopt;
}

/// A restitution parts the root of its group, by the impulse kept at the load and eq. (3).
std::optional<std::string> parts_wrongly(const ImpliedState& before, const TracedEvent& event, Real u) {
  const int i = before.index_of(*event.i), j = before.index_of(*event.j);
  const LoadedNode* node = before.node(i, j);
  if (node == nullptr) return "a restitution of a pair that is not loaded";
  for (const LoadedNode& other : before.body(before.is_fixed(i) ? j : i)->nodes) {
    if (other.particles().size() > node->particles().size() &&
        std::ranges::includes(other.particles(), node->particles()))
      return "a node is given back before the one above it";
  }
  if (event.dp.value() != node->dp) return "the impulse given back is not the one that was kept";
  for (const auto& [p, sign] : {std::pair{i, 1}, std::pair{j, -1}}) {
    if (before.is_fixed(p)) continue;
    const Point v = event.pre.at(before.id_of(p)).velocity, w = event.post.at(before.id_of(p)).velocity;
    const Point expected = v + sign * node->dp / node->mass_of(p);
    if (auto fault = beyond("velocity of " + std::to_string(before.id_of(p)) + " after the restitution",
                            (w - expected).norm(),
                            4 * u * kSpare * (v.norm() + w.norm()) + directed_change(before, event, u)))
      return fault;
  }
  return std::nullopt;
}

/// A group that should have been given back before an instant.
std::optional<std::string> overdue(const ImpliedState& before, const Instant& t, Real dt, Real late) {
  for (const LoadedBody& body : before.bodies()) {
    if (auto fault = beyond("age of the latest load of the group " + name_of(before, body.members),
                            elapsed(body.last_load, t), dt + late))
      return fault;
  }
  return std::nullopt;
}

/// By how much an expiry may be beside its time: rounding (2 u² t, far below 16 u dt where it matters), and
/// what the certified order may hold it back (docs/engine.md: 8 u t).
Real expiry_error(const Simulator& simulator, Real dt, const Instant& t) {
  return 16 * simulator.roundoff() * (simulator.timing() == "certified" ? dt + t.hi : dt);
}

RunVerdict unwinds(const Scene& scene, Simulator& simulator) {
  const Real u = simulator.roundoff();
  const ImpliedState start(scene, simulator.scalar());
  const Real dt = start.stored(scene.grouping->dt_restitute);
  return RunVerdict::of(first_fault(
      scene, simulator,
      [&](const ImpliedState& before, const TracedEvent& event) -> std::optional<std::string> {
        const Real late = expiry_error(simulator, dt, event.t);
        if (auto fault = overdue(before, event.t, dt, late)) return fault;
        if (event.is_load()) return unites_wrongly(before, event);
        if (event.is_collision() && !event.dp->isZero(0)) return "a collision with an impulse loads nothing";
        if (event.kind != "restitute") return std::nullopt;
        if (auto fault = parts_wrongly(before, event, u)) return fault;
        const int i = before.index_of(*event.i), j = before.index_of(*event.j);
        const LoadedBody* body = before.body(before.is_fixed(i) ? j : i);
        return beyond("a group is given back early, by", dt - elapsed(body->last_load, event.t), late);
      }));
}

/// Particles in a finite scene, the infinite masses counted as one.
Real bodies_at_most(const Scene& scene, const ImpliedState& implied) {
  int finite = 0;
  for (int i = 0; i < implied.size(); ++i) finite += implied.is_fixed(i) ? 0 : 1;
  return Real(finite + (finite < static_cast<int>(scene.particles.size()) ? 1 : 0));
}

/// Each load unites two bodies for at least Δt_restitute, so of N bodies there are at most N − 1 in each such
/// time.
RunVerdict has_few_events(const Scene& scene, Simulator& simulator) {
  const RunTrace trace = simulator.run(scene, {.max_events = 300, .state_every = 0});
  const ImpliedState start(scene, simulator.scalar());
  const auto loads = std::count_if(trace.events.begin(), trace.events.end(),
                                   [](const TracedEvent& e) { return e.is_load() || e.kind == "restitute"; });
  const Real most = 2 * (bodies_at_most(scene, start) - 1) *
                    (trace.end_time.hi / start.stored(scene.grouping->dt_restitute) + 1);
  return RunVerdict::of(beyond("loads and restitutions", Real(loads), std::floor(most * kSpare)));
}

/// The velocities that members of a group will have: what they move with and ±Δp_AB/m of each node above
/// them, the deepest first, as no implementation unwinds them.
std::map<int, Point> unwound_from_below(const ImpliedState& implied, const LoadedBody& body) {
  std::map<int, Point> velocities;
  for (const int p : body.members) velocities[p] = implied.flight(p).velocity;
  for (const LoadedNode& node : body.nodes) {
    for (const int p : node.side_i) velocities[p] += node.dp / node.mass_i;
    for (const int p : node.side_j) velocities[p] -= node.dp / node.mass_j;
  }
  return velocities;
}

struct Unwinding {
  std::map<int, Point> expected;
  Real speeds = 0;    ///< of i and j before and after each node; each adds 2 u of them
  Real directed = 0;  ///< what directed rounding may have changed
};

bool is_over(const ImpliedState& after, const Unwinding& unwinding) {
  return std::ranges::none_of(unwinding.expected,
                              [&](const auto& p) { return after.body(p.first) != nullptr; });
}

std::optional<std::string> unwound_elsewhere(const ImpliedState& after, const Unwinding& unwinding, Real u) {
  for (const auto& [p, velocity] : unwinding.expected) {
    if (auto fault =
            beyond("velocity of " + std::to_string(after.id_of(p)) + " beside the sum of its nodes' impulses",
                   (after.flight(p).velocity - velocity).norm(),
                   4 * u * kSpare * unwinding.speeds + unwinding.directed))
      return fault;
  }
  return std::nullopt;
}

RunVerdict order_is_irrelevant(const Scene& scene, Simulator& simulator) {
  const Real u = simulator.roundoff();
  std::optional<Unwinding> open;
  return RunVerdict::of(first_fault(
      scene, simulator,
      [&](const ImpliedState& before, const TracedEvent& event) -> std::optional<std::string> {
        if (event.kind != "restitute")
          return open ? std::optional<std::string>("a group is only given back in part") : std::nullopt;
        const int i = before.index_of(*event.i), j = before.index_of(*event.j);
        const LoadedBody* body = before.body(before.is_fixed(i) ? j : i);
        if (body == nullptr) return "a restitution of particles that are not loaded";
        if (!open) open = Unwinding{unwound_from_below(before, *body), 0, 0};
        const LoadedNode* node = before.node(i, j);
        if (node == nullptr) return "a restitution of a pair that is not loaded";
        open->directed += directed_change(before, event, u);
        for (const auto& [id, state] : event.post)
          open->speeds += state.velocity.norm() + event.pre.at(id).velocity.norm();
        ImpliedState after = before;
        after.apply(event);
        if (!is_over(after, *open)) return std::nullopt;
        return unwound_elsewhere(after, *std::exchange(open, std::nullopt), u);
      }));
}

}  // namespace

std::vector<RunLaw> group_laws() {
  Wanted grouped;
  grouped.grouping = Wanted::Choice::always;
  Wanted undisturbed = grouped;
  undisturbed.outside = false;
  return {
      {11, "Groups",
       "A load unites the two bodies, never an infinite mass; the group is given back Δt_restitute after its "
       "latest load, root first, each node by the impulse it kept.",
       "docs/engine.md", of(grouped), unwinds},
      {12, "EventBound", "In [0, T] there are at most 2(N − 1)(T/Δt_restitute + 1) loads and restitutions.",
       "docs/engine.md", of(undisturbed), has_few_events},
      {13, "Siblings",
       "After an unwinding every member moves with the sum of the impulses above it, in whatever order "
       "they are added.",
       "docs/engine.md", of(grouped), order_is_irrelevant},
  };
}

}  // namespace tps::properties::runs
