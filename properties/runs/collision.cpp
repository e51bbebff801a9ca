#include "properties/runs/collision.hpp"

#include <algorithm>
#include <cmath>

#include "properties/runs/laws.hpp"

namespace tps::properties::runs {
namespace {

const Real kPi = std::acos(Real(-1));

Real radians(Real degrees) {
  return degrees * kPi / 180;
}

/// v_AB' of eq. (5): |v_AB| c^(θ/π), inward at θ from perpendicular, in the plane of axis and v_AB.
Point revolved(const Collided& c, Real c_revolve, Real theta_deg) {
  const Real speed = c.v_AB.norm() * std::pow(c_revolve, theta_deg / 180);
  const Real theta = radians(theta_deg);
  return speed * (std::cos(theta) * c.v_across.normalized() - std::sin(theta) * c.axis);
}

/// Which answers of a tether are right, and which rounding leaves open: at the boundary |c v_n| cos θ = sin θ
/// |v_ŵ|, and where there is next to no motion along or across. A pair that rounding has left approaching
/// revolves (D16).
struct Answers {
  bool retract, revolve, nothing;
};
Answers allowed_answers(const ImpliedState& implied, const Collided& c, const TetheringLaw& law, Real u) {
  const Real speed = c.v_AB.norm();
  const Real theta = radians(implied.stored_angle(law.theta_revolve_deg));
  const Real along = std::abs(implied.stored(law.c_retract) * c.v_n) * std::cos(theta);
  const Real across = c.v_across.norm() * std::sin(theta);
  const bool undecided = std::abs(along - across) <= 32 * u * speed || c.v_across.norm() <= 32 * u * speed;
  const bool rests_across = c.v_across.norm() <= 32 * u * speed;
  if (c.v_n < -32 * u * speed) return {false, true, rests_across};
  if (c.v_n <= 32 * u * speed) return {true, true, rests_across};
  return {along > across || undecided, along <= across || undecided, false};
}

std::optional<std::string> wrong_rebound(const Collided& c, const TracedEvent& event, Real coefficient,
                                         Real u) {
  const Point dp = event.dp.value();
  if (dp.isZero(0) && c.v_n >= -32 * u * c.v_AB.norm()) return std::nullopt;
  const Point expected = (1 + coefficient) * c.mu * c.v_n * c.axis;
  return beyond("impulse of the rebound beside eq. (4)", (dp - expected).norm(),
                44 * u * kSpare * c.mu * c.v_AB.norm());
}

std::optional<std::string> wrong_retraction(const ImpliedState& implied, const Collided& c,
                                            const TracedEvent& event, const TetheringLaw& law, Real u) {
  const Point dp = event.dp.value();
  const Answers allowed = allowed_answers(implied, c, law, u);
  if (event.kind == "revolve") {
    if (!allowed.revolve) return "a revolution where retraction suffices";
    const Point expected = c.mu * (c.v_AB - revolved(c, implied.stored(law.c_revolve),
                                                     implied.stored_angle(law.theta_revolve_deg)));
    // v_ŵ errs by 15 u |v_AB|, so its direction by 15 u |v_AB|/|v_ŵ|; tan θ, lengths, powers and μ by 21 u
    // more.
    const Real direction = 15 * c.v_AB.norm() / c.v_across.norm() + 21;
    if (!(direction * u < 1)) return std::nullopt;
    return beyond("impulse of the revolution beside eq. (5)", (dp - expected).norm(),
                  direction * u * kSpare * c.mu * c.v_AB.norm());
  }
  if (dp.isZero(0) && allowed.nothing) return std::nullopt;
  if (!allowed.retract) return "a retraction that does not suffice";
  const Point expected = (1 + implied.stored(law.c_retract)) * c.mu * c.v_n * c.axis;
  return beyond("impulse of the retraction beside eq. (4)", (dp - expected).norm(),
                44 * u * kSpare * c.mu * c.v_AB.norm());
}

}  // namespace

Collided collided(const ImpliedState& before, const TracedEvent& event) {
  Collided c{};
  c.i = before.index_of(event.i.value());
  c.j = before.index_of(event.j.value());
  c.mass_i = before.body_mass(c.i);
  c.mass_j = before.body_mass(c.j);
  if (event.kind == "restitute") {
    if (const LoadedNode* node = before.node(c.i, c.j)) {
      c.mass_i = node->mass_i;
      c.mass_j = node->mass_j;
    }
  }
  c.mu = reduced(c.mass_i, c.mass_j);
  const TracedState &a = event.pre.at(*event.i), &b = event.pre.at(*event.j);
  c.v_i = a.velocity;
  c.v_j = b.velocity;
  c.v_AB = c.v_j - c.v_i;
  const Point r = b.position - a.position;
  c.distance = r.norm();
  c.axis = r / c.distance;
  c.v_n = c.v_AB.dot(c.axis);
  c.v_across = c.v_AB - c.v_n * c.axis;
  return c;
}

Point load_velocity(const Collided& c) {
  if (std::isinf(c.mass_i)) return c.v_i;
  if (std::isinf(c.mass_j)) return c.v_j;
  return (c.mass_i * c.v_i + c.mass_j * c.v_j) / (c.mass_i + c.mass_j);
}

Real energy_lost(const ImpliedState& before, const Collided& c, const TracedEvent& event) {
  if (event.dp.value().isZero(0)) return 0;
  const PairLaw& law = *before.law(c.i, c.j);
  if (event.kind == "revolve") {
    const Real kept = std::pow(before.stored(law.tethering->c_revolve),
                               before.stored_angle(law.tethering->theta_revolve_deg) / 90);
    return c.mu / 2 * (1 - kept) * c.v_AB.squaredNorm();
  }
  const Real coefficient =
      before.stored(event.kind == "rebound" ? law.blocking->c_rebound : law.tethering->c_retract);
  return c.mu / 2 * (1 - coefficient * coefficient) * c.v_n * c.v_n;
}

Real directed_change(const ImpliedState& before, const TracedEvent& event, Real u) {
  const bool restitution = event.kind == "restitute";
  if (!restitution && (!event.is_collision() || event.is_load())) return 0;
  const Collided c = collided(before, event);
  const TracedState &i = event.post.at(*event.i), &j = event.post.at(*event.j);
  const LoadedNode* node = restitution ? before.node(c.i, c.j) : nullptr;
  const Real speeds = c.v_i.norm() + c.v_j.norm() + i.velocity.norm() + j.velocity.norm() +
                      (node != nullptr ? node->speeds : 0);
  const Real turn = restitution ? 4 * std::max(i.position.norm(), j.position.norm()) / c.distance : 0;
  const Real error = u * kSpare * speeds * (54 + turn);
  if (std::abs(c.v_n - event.dp.value().dot(c.axis) / c.mu) > error) return 0;
  return std::sqrt(Real(before.dimension())) * error;
}

Real tether_impulse(const ImpliedState& before, const Collided& c) {
  const TetheringLaw& law = *before.law(c.i, c.j)->tethering;
  const Real c_retract = before.stored(law.c_retract);
  const Real theta = before.stored_angle(law.theta_revolve_deg);
  const bool retracts = c.v_across.isZero(0) || std::abs(c_retract * c.v_n) * std::cos(radians(theta)) >
                                                    c.v_across.norm() * std::sin(radians(theta));
  if (retracts) return (1 + c_retract) * c.mu * std::abs(c.v_n);
  return c.mu * (c.v_AB - revolved(c, before.stored(law.c_revolve), theta)).norm();
}

std::optional<std::string> wrong_impulse(const ImpliedState& before, const Collided& c,
                                         const TracedEvent& event, Real u) {
  const PairLaw* law = before.law(c.i, c.j);
  if (law == nullptr) return "a collision of two particles that do not interact";
  if (event.kind == "rebound") {
    if (!law->blocking) return "a rebound of a pair without blocking";
    return wrong_rebound(c, event, before.stored(law->blocking->c_rebound), u);
  }
  if (!law->tethering) return "a tethering collision of a pair without tethering";
  return wrong_retraction(before, c, event, *law->tethering, u);
}

}  // namespace tps::properties::runs
