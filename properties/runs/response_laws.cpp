// What an event does: momentum, energy, and the responses of eqs. (3)-(7), each judged from the trace's own
// state before the event.
#include <algorithm>
#include <cmath>
#include <set>

#include "properties/runs/collision.hpp"
#include "properties/runs/laws.hpp"

namespace tps::properties::runs {
namespace {

/// The velocities after an event of every particle that it moves: of groups, too, whose other members are not
/// named at a restitution.
ImpliedState after_event(const ImpliedState& before, const TracedEvent& event) {
  ImpliedState after = before;
  after.apply(event);
  return after;
}

/// The finite masses that an event moves, or would have moved had rounding not erased it.
std::set<int> concerned(const ImpliedState& before, const TracedEvent& event) {
  std::set<int> all;
  for (const auto& [id, state] : event.post) {
    if (!before.is_fixed(before.index_of(id))) all.merge(before.with(before.index_of(id)));
  }
  return all;
}

/// Σ m s over them, s = |v| + |v'|: of this a momentum errs by roundings.
Real momentum_share(const ImpliedState& before, const ImpliedState& after, const TracedEvent& event) {
  Real share = 0;
  for (const int i : concerned(before, event)) {
    share += before.mass(i) * (before.flight(i).velocity.norm() + after.flight(i).velocity.norm());
  }
  return share;
}

/// |v − V| + |v' − V|: an energy counts in the walls' frame.
Real speeds_in_frame(int i, const ImpliedState& before, const ImpliedState& after) {
  const Point& V = before.frame_velocity();
  return (before.flight(i).velocity - V).norm() + (after.flight(i).velocity - V).norm();
}

/// Σ m s max(s, s_V) over them: of this an energy errs. A velocity is rounded as the scene's frame has it.
Real energy_share(const ImpliedState& before, const ImpliedState& after, const TracedEvent& event) {
  Real share = 0;
  for (const int i : concerned(before, event)) {
    const Real speeds = before.flight(i).velocity.norm() + after.flight(i).velocity.norm();
    share += before.mass(i) * speeds * std::max(speeds, speeds_in_frame(i, before, after));
  }
  return share;
}

/// What directed rounding may change of a momentum and of an energy, by the lighter of the two bodies.
struct Directed {
  Real momentum = 0, energy = 0;
};
Directed directed(const ImpliedState& before, const ImpliedState& after, const TracedEvent& event, Real u) {
  const Real change = directed_change(before, event, u);
  if (change == 0) return {};
  const Collided c = collided(before, event);
  const Real momentum = std::min(c.mass_i, c.mass_j) * change;
  return {momentum,
          momentum * std::max(speeds_in_frame(c.i, before, after), speeds_in_frame(c.j, before, after))};
}

/// The impulse on the body of i (sign −1: of j) that an infinite mass gave; nothing where none took part.
std::optional<Point> from_wall(const Collided& c, const TracedEvent& event) {
  if (!std::isinf(c.mass_i) && !std::isinf(c.mass_j)) return std::nullopt;
  const Point on_i = event.is_load() ? Point(c.mu * c.v_AB) : event.dp.value_or(Point::Zero());
  return std::isinf(c.mass_j) ? on_i : Point(-on_i);
}

// Eq. (3) errs by 2 u m (|v| + |v'|) a particle; eq. (6) by 5 u: a weight 3, product and sum. Together
// below 8. Δp and μ v_AB of a wall err by 1 u and 4 u of themselves, which are at most m (|v| + |v'|) as
// well.
std::optional<std::string> conserves_momentum(const ImpliedState& before, const TracedEvent& event, Real u) {
  if (!event.i) return std::nullopt;
  const ImpliedState after = after_event(before, event);
  Point change = Point::Zero();
  for (int i = 0; i < before.size(); ++i) {
    if (!before.is_fixed(i))
      change += before.mass(i) * (after.flight(i).velocity - before.flight(i).velocity);
  }
  if (event.kind == "scheduled_impulse") {
    if (!std::isinf(before.body_mass(before.index_of(*event.i)))) change -= *event.dp;
  } else if (const std::optional<Point> impulse = from_wall(collided(before, event), event)) {
    change -= *impulse;
  }
  return beyond(
      "change of momentum", change.norm(),
      16 * u * kSpare * momentum_share(before, after, event) + directed(before, after, event, u).momentum);
}

/// ½ Σ m (|v' − V|² − |v − V|²), as differences, beside which no energy of others is large.
Real kinetic_change(const ImpliedState& before, const ImpliedState& after) {
  Real change = 0;
  for (int i = 0; i < before.size(); ++i) {
    if (before.is_fixed(i)) continue;
    const Point &v = before.flight(i).velocity, &w = after.flight(i).velocity;
    change += before.mass(i) / 2 * (w - v).dot(w + v - 2 * before.frame_velocity());
  }
  return change;
}

/// |Δp_AB|²/2μ that a load stores, or a restitution gives back.
Real stored_change(const ImpliedState& before, const TracedEvent& event) {
  if (!event.is_load() && event.kind != "restitute") return 0;
  const Real mu = collided(before, event).mu;
  if (event.is_load()) return event.dp_stored.value_or(Point::Zero()).squaredNorm() / mu / 2;
  return -event.dp.value().squaredNorm() / mu / 2;
}

// docs/ledger.md derives less than 40 u m s max(s, s_V); it uses 64.
std::optional<std::string> accounts_for_energy(const ImpliedState& before, const TracedEvent& event, Real u) {
  if (!event.i) return std::nullopt;
  const ImpliedState after = after_event(before, event);
  Real expected = 0;
  if (event.kind == "scheduled_impulse") {
    const int i = before.index_of(*event.i);
    const Point v = before.flight(i).velocity - before.frame_velocity();
    expected = event.dp->dot(v) + event.dp->squaredNorm() / before.body_mass(i) / 2;
  } else if (event.is_collision()) {
    expected = -energy_lost(before, collided(before, event), event);
  }
  const Real change = kinetic_change(before, after) + stored_change(before, event);
  return beyond(
      "kinetic + stored energy beside what coefficients and impulses account for",
      std::abs(change - expected),
      64 * u * kSpare * energy_share(before, after, event) + directed(before, after, event, u).energy);
}

/// Velocities after an impulse or a load, by eqs. (3) and (6): 2u of |v| + |v'|; 6u for (6). Directed
/// rounding changes the lighter body, of equal masses either.
std::optional<std::string> moves_bodies(const ImpliedState& before, const TracedEvent& event,
                                        const Collided& c, Real u) {
  const bool load = event.is_load();
  const Point common = load_velocity(c);
  const Real directed = directed_change(before, event, u);
  for (const auto& [id, state] : event.post) {
    const int p = before.index_of(id);
    const Point& v = before.flight(p).velocity;
    if (before.is_fixed(p)) continue;
    const bool of_i = before.with(c.i).contains(p);
    const Point impulse = event.dp.value_or(Point::Zero());
    const Point change = of_i ? Point(impulse / c.mass_i) : Point(-impulse / c.mass_j);
    const Point expected = load ? common : Point(v + change);
    const Real speeds = v.norm() + state.velocity.norm() + (load ? c.v_AB.norm() : 0);
    const bool lighter = of_i ? c.mass_i <= c.mass_j : c.mass_j <= c.mass_i;
    if (auto fault = beyond("velocity of " + std::to_string(id) + " after the event",
                            (state.velocity - expected).norm(),
                            (load ? 8 : 2) * 2 * u * kSpare * speeds + (lighter ? directed : 0)))
      return fault;
    if (load && state.velocity != event.post.begin()->second.velocity &&
        !before.is_fixed(before.index_of(event.post.begin()->first)))
      return "members of a group have different velocities";
  }
  return std::nullopt;
}

std::optional<std::string> responds(const ImpliedState& before, const TracedEvent& event, Real u) {
  if (!event.is_collision()) return std::nullopt;
  const Collided c = collided(before, event);
  const Point dp = event.dp.value();
  if (const auto fault = moves_bodies(before, event, c, u)) return fault;
  if (event.is_load()) {
    // Eq. (7): two differences and a product with μ, whose three roundings count.
    const Point kept = dp - c.mu * c.v_AB;
    if (const auto fault = beyond("impulse kept by eq. (7)", (event.dp_stored.value() - kept).norm(),
                                  6 * u * kSpare * (dp.norm() + c.mu * c.v_AB.norm())))
      return fault;
  }
  return wrong_impulse(before, c, event, u);
}

using Judge = std::optional<std::string> (*)(const ImpliedState&, const TracedEvent&, Real);

RunLaw law(int number, std::string name, std::string sentence, std::string page, Judge judge) {
  return {number,
          std::move(name),
          std::move(sentence),
          std::move(page),
          of({}),
          [judge](const Scene& scene, Simulator& simulator) {
            const Real u = simulator.roundoff();
            return RunVerdict::of(
                first_fault(scene, simulator, [&](const ImpliedState& before, const TracedEvent& event) {
                  return judge(before, event, u);
                }));
          }};
}

}  // namespace

std::vector<RunLaw> response_laws() {
  return {
      law(1, "Momentum",
          "Every event conserves the momentum of the finite masses, but for the recorded impulses of "
          "infinite masses and from outside.",
          "docs/ledger.md", conserves_momentum),
      law(2, "Energy",
          "Kinetic + stored energy falls at every collision by what its coefficient takes, by nothing "
          "where that is 1, and never rises but by the work of impulses; so the ledger closes.",
          "docs/ledger.md", accounts_for_energy),
      law(3, "Responses",
          "Every collision gives eq. (4)'s impulse, or eq. (5)'s where retraction does not suffice; it "
          "acts by eq. (3), or loads by eqs. (6) and (7).",
          "docs/eq4.md", responds),
  };
}

}  // namespace tps::properties::runs
