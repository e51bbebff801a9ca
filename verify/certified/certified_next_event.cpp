#include "verify/certified/certified_next_event.hpp"

#include "verify/certified/enclosure.hpp"
#include "verify/certified/response.hpp"
#include "verify/certified/timing_input.hpp"
#include "verify/exact/exact_verdict.hpp"
#include "verify/exact/time_order.hpp"

namespace tps::certified {
namespace {

/// The one that is before all others.
std::optional<std::size_t> earliest(const std::vector<exact::TimingQuery>& queries) {
  exact::Counters counters;
  std::optional<std::size_t> first;
  bool tied = false;
  for (std::size_t n = 0; n < queries.size(); ++n) {
    if (!exact::occurs(exact::exact_verdict(queries[n], counters))) continue;
    const exact::Order order =
        first ? exact::time_order(queries[n], queries[*first], counters) : exact::Order::before;
    if (order == exact::Order::equal) tied = true;
    if (order != exact::Order::before) continue;
    first = n;
    tied = false;
  }
  return tied ? std::nullopt : first;
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
  const GroupInput::Body& A = input.bodies[limit.i];
  const GroupInput::Body& B = input.bodies[limit.j];
  return {limit.kind,           in_space(A.position), in_space(B.position),
          in_space(A.velocity), in_space(B.velocity), limit.L};
}

std::optional<CertifiedNextEvent> certified_next_event(const NextEventInput& input) {
  std::vector<exact::TimingQuery> queries;
  for (const PairLimit& limit : input.limits) queries.push_back(timing_query(input, limit));
  const std::optional<std::size_t> first = earliest(queries);
  if (!first) return std::nullopt;
  const PairLimit& limit = input.limits[*first];
  std::vector<RealVector> positions, velocities;
  for (const GroupInput::Body& body : input.bodies) {
    positions.push_back(lifted(body.position));
    velocities.push_back(lifted(body.velocity));
  }
  const Real dt = time_of(queries[*first], positions[limit.j] - positions[limit.i],
                          velocities[limit.j] - velocities[limit.i]);
  for (std::size_t n = 0; n < positions.size(); ++n) positions[n] = positions[n] + dt * velocities[n];

  const Real inverse_i = inverse_mass(input.bodies[limit.i].mass);
  const Real inverse_j = inverse_mass(input.bodies[limit.j].mass);
  const Collision pair = collision(positions[limit.j] - positions[limit.i],
                                   velocities[limit.j] - velocities[limit.i], inverse_i, inverse_j);
  std::string kind = "rebound";
  if (limit.kind == exact::Kind::tether) {
    const TetherDecision decision = tether_decision(pair, limit.c, limit.theta_revolve_deg);
    if (decision.boundary) return std::nullopt;
    kind = decision.retracts ? "retract" : "revolve";
  }
  const RealVector dp = kind == "revolve" ? revolution_impulse(pair, limit.c_revolve, limit.theta_revolve_deg)
                                          : collision_impulse(pair, limit.c);
  velocities[limit.i] = velocities[limit.i] + inverse_i * dp;
  velocities[limit.j] = velocities[limit.j] - inverse_j * dp;

  CertifiedNextEvent event{*first, kind, enclosure(dt), {}, {}};
  for (const RealVector& u : positions) event.positions.push_back(enclosure(u));
  for (const RealVector& v : velocities) event.velocities.push_back(enclosure(v));
  return event;
}

}  // namespace tps::certified
