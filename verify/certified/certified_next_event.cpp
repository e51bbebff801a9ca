#include "verify/certified/certified_next_event.hpp"

#include <algorithm>
#include <cmath>

#include "verify/certified/enclosure.hpp"
#include "verify/certified/response.hpp"
#include "verify/exact/exact_verdict.hpp"
#include "verify/exact/time_order.hpp"
#include "verify/operations/timing_input.hpp"

namespace tps::certified {
namespace {

struct Earliest {
  std::size_t limit;
  exact::TimingQuery query;
  bool tied;
};

/// The one that no other is before; the first of those at one time.
std::optional<Earliest> earliest(const NextEventInput& input) {
  exact::Counters counters;
  std::optional<Earliest> first;
  for (std::size_t n = 0; n < input.limits.size(); ++n) {
    const exact::TimingQuery query = timing_query(input, input.limits[n]);
    if (!exact::occurs(exact::exact_verdict(query, counters))) continue;
    const exact::Order order =
        first ? exact::time_order(query, first->query, counters) : exact::Order::before;
    if (order == exact::Order::before) first = Earliest{n, query, false};
    if (order == exact::Order::equal) first->tied = true;
  }
  return first;
}

/// When the pair is at its limit: the smaller or the larger root of eq. (2), or closest approach.
Real time_of(const exact::TimingQuery& query, const RealVector& r, const RealVector& v) {
  exact::Counters counters;
  const exact::Verdict verdict = exact::exact_verdict(query, counters);
  if (exact::at_once(verdict)) return Real(0);
  const Real a = dot(v, v);
  const Real h = dot(r, v);
  if (verdict == exact::Verdict::turning) return Real(0) - h / a;
  const Real L = Real::of(query.L);
  const Real root = sqrt(h * h - a * (dot(r, r) - L * L));
  return (query.kind == exact::Kind::block ? Real(0) - h - root : root - h) / a;
}

}  // namespace

exact::TimingQuery timing_query(const NextEventInput& input, const PairLimit& limit) {
  const operations::GroupInput::Body& A = input.bodies[limit.i];
  const operations::GroupInput::Body& B = input.bodies[limit.j];
  return {limit.kind,
          operations::in_space(A.position),
          operations::in_space(B.position),
          operations::in_space(A.velocity),
          operations::in_space(B.velocity),
          limit.L};
}

namespace {

/// What a collision does to its pair.
struct Outcome {
  std::string kind, tether;
  RealVector dp;
  bool boundary = false;
};

Outcome response_of(const PairLimit& limit, const Collision& pair) {
  if (limit.kind == exact::Kind::block)
    return {"rebound", limit.forms ? "formed" : "", collision_impulse(pair, limit.c)};
  const TetherDecision decision = tether_decision(pair, limit.c, limit.theta_revolve_deg);
  const RealVector dp = decision.retracts
                            ? collision_impulse(pair, limit.c)
                            : revolution_impulse(pair, limit.c_revolve, limit.theta_revolve_deg);
  Outcome response{decision.retracts ? "retract" : "revolve", "", dp, decision.boundary};
  Sign above = limit.breaks ? Sign::positive : Sign::negative;
  if (limit.breaks_above && std::isfinite(*limit.breaks_above)) {
    const Real threshold = Real::of(*limit.breaks_above);
    above = sign(dot(dp, dp) - threshold * threshold);
    response.boundary = response.boundary || above == Sign::zero || above == Sign::uncertain;
  }
  if (above == Sign::positive) return {"break", "broken", Real(0) * dp, response.boundary};
  return response;
}

bool all_settled(const std::vector<EnclosedVector>& vectors) {
  for (const EnclosedVector& x : vectors) {
    if (!std::all_of(x.begin(), x.end(), [](const Enclosure& e) { return e.settled; })) return false;
  }
  return true;
}

/// At the working precision.
CertifiedNextEvent happened(const NextEventInput& input, const Earliest& first) {
  const PairLimit& limit = input.limits[first.limit];
  std::vector<RealVector> positions, velocities;
  for (const operations::GroupInput::Body& body : input.bodies) {
    positions.push_back(lifted(body.position));
    velocities.push_back(lifted(body.velocity));
  }
  const Real dt = time_of(first.query, positions[limit.j] - positions[limit.i],
                          velocities[limit.j] - velocities[limit.i]);
  for (std::size_t n = 0; n < positions.size(); ++n) positions[n] = positions[n] + dt * velocities[n];

  const Real inverse_i = inverse_mass(input.bodies[limit.i].mass);
  const Real inverse_j = inverse_mass(input.bodies[limit.j].mass);
  RealVector& v_i = velocities[limit.i];
  RealVector& v_j = velocities[limit.j];
  const Collision pair = collision(positions[limit.j] - positions[limit.i], v_j - v_i, inverse_i, inverse_j);
  const Outcome response = response_of(limit, pair);
  if (input.grouped && response.kind != "break") {
    v_i = load_velocity(inverse_i, inverse_j, v_i, v_j);
    v_j = v_i;
  } else {
    v_i = v_i + inverse_i * response.dp;
    v_j = v_j - inverse_j * response.dp;
  }

  CertifiedNextEvent event{first.limit, response.kind, response.tether,  enclosure(dt), {},
                           {},          first.tied,    response.boundary};
  for (const RealVector& u : positions) event.positions.push_back(enclosure(u));
  for (const RealVector& v : velocities) event.velocities.push_back(enclosure(v));
  event.settled = event.dt.settled && all_settled(event.positions) && all_settled(event.velocities);
  return event;
}

}  // namespace

std::optional<CertifiedNextEvent> certified_next_event(const NextEventInput& input) {
  const std::optional<Earliest> first = earliest(input);
  if (!first) return std::nullopt;
  return settled([&] { return happened(input, *first); });
}

}  // namespace tps::certified
