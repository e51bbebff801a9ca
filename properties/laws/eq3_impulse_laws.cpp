// Eq. (3), docs/eq3.md.
#include "properties/generators/cases.hpp"
#include "properties/generators/numbers.hpp"
#include "properties/law.hpp"
#include "properties/laws/compare.hpp"

namespace tps::properties::eq3 {
namespace {

void pushed_pair(Case& c, const Format& format) {
  c.dimension = whole(2, 4);
  c.hazard = one_of<std::string>({"finite_masses", "infinite_mass", "equal_masses"});
  Masses m = finite_masses(format);
  if (c.hazard == "equal_masses") m.B = m.A;
  if (c.hazard == "infinite_mass") (coin() ? m.A : m.B) = HUGE_VAL;
  c.set(m);
  for (const char* key : {"v_A", "v_B", "dp"}) c.set(key, vector(format, c.dimension));
}

Velocities after(Interview& ask, const Case& c) {
  return ask.apply_impulse(c.masses(), c.vector("v_A"), c.vector("v_B"), c.vector("dp"));
}

// m v' = m v + Δp + δ₁ Δp + δ₂ m v' for each body and component: |δ₂| ≤ u, and |δ₁| ≤ 2u, one for the
// quotient Δp/m, or two for Δp times a rounded 1/m. Second orders are in kSlack.
Outcome momentum_is_conserved(Interview& ask, const Case& c) {
  const Masses m = c.masses();
  if (std::isinf(m.A) || std::isinf(m.B)) return outside("an infinite mass takes any momentum");
  const auto v_A = components(wide(c.vector("v_A"))), v_B = components(wide(c.vector("v_B")));
  const auto dp = components(wide(c.vector("dp")));
  const Velocities answer = after(ask, c);
  const auto new_A = components(answer.v_A), new_B = components(answer.v_B);
  const Wide m_A(m.A), m_B(m.B);
  Outcome outcome;
  for (std::size_t k = 0; k < 3; ++k) {
    const Wide gained = m_A * (new_A[k] - v_A[k]) + m_B * (new_B[k] - v_B[k]);
    const Wide sizes = 4 * abs(dp[k]) + m_A * abs(new_A[k]) + m_B * abs(new_B[k]);
    outcome = all_of(outcome, at_most("the momentum gained", abs(gained), ask.u() * sizes * kSlack));
  }
  return outcome;
}

Outcome no_impulse_no_change(Interview& ask, const Case& c) {
  const Vec3 v_A = c.vector("v_A"), v_B = c.vector("v_B");
  const Velocities answer = ask.apply_impulse(c.masses(), v_A, v_B, {});
  return all_of(same("v_A after no impulse", answer.v_A, wide(v_A)),
                same("v_B after no impulse", answer.v_B, wide(v_B)));
}

Outcome an_infinite_mass_keeps_its_velocity(Interview& ask, const Case& c) {
  const Masses m = c.masses();
  if (!std::isinf(m.A) && !std::isinf(m.B)) return outside("both masses are finite");
  const Velocities answer = after(ask, c);
  if (std::isinf(m.A)) return same("v_A of the infinite mass", answer.v_A, wide(c.vector("v_A")));
  return same("v_B of the infinite mass", answer.v_B, wide(c.vector("v_B")));
}

/// What rounding does to v' = v + Δp/m, by the same count, twice: once for each of two answers.
Wide twice_the_rounding(Interview& ask, double mass, const Vec3& dp, const WideVector& after) {
  return 2 * ask.u() * (2 * inverse_mass(mass) * norm(wide(dp)) + norm(after)) * kSlack;
}

Outcome swap_of_names(Interview& ask, const Case& c) {
  const Vec3 dp = c.vector("dp");
  const Velocities answer = after(ask, c);
  const Velocities other = ask.apply_impulse(swapped(c.masses()), c.vector("v_B"), c.vector("v_A"),
                                             {0 - dp[0], 0 - dp[1], 0 - dp[2]});
  const Masses m = c.masses();
  return all_of(same_to("v_A' with the names exchanged", other.v_B, answer.v_A,
                        twice_the_rounding(ask, m.A, dp, answer.v_A)),
                same_to("v_B' with the names exchanged", other.v_A, answer.v_B,
                        twice_the_rounding(ask, m.B, dp, answer.v_B)));
}

}  // namespace

void add_laws(std::vector<Law>& laws) {
  const std::string page = "docs/eq3.md";
  const std::vector<Op> operation{Op::apply_impulse};
  laws.push_back(
      {{"Eq3Laws.Law1MomentumIsConserved", "(3) law 1",
        "m_A v_A + m_B v_B is conserved, each component to u (4|Δp| + m_A|v_A'| + m_B|v_B'|)", page},
       operation,
       cases(pushed_pair),
       momentum_is_conserved});
  laws.push_back({{"Eq3Laws.Law2NoImpulseNoChange", "(3) law 2", "Δp = 0 changes nothing, bitwise", page},
                  operation,
                  cases(pushed_pair),
                  no_impulse_no_change});
  laws.push_back({{"Eq3Laws.Law3AnInfiniteMassKeepsItsVelocity", "(3) law 3",
                   "an infinite mass keeps its velocity, bitwise", page},
                  operation,
                  cases(pushed_pair),
                  an_infinite_mass_keeps_its_velocity});
  laws.push_back(
      {{"Eq3Laws.Law4SwapOfNames", "(3) law 4", "A and B may be exchanged with −Δp for Δp, bitwise", page},
       operation,
       cases(pushed_pair),
       swap_of_names});
}

}  // namespace tps::properties::eq3
