// Eq. (7), with (6) and (3); docs/eq7.md.
#include "properties/generators/cases.hpp"
#include "properties/generators/numbers.hpp"
#include "properties/law.hpp"
#include "properties/laws/compare.hpp"

namespace tps::properties::eq7 {
namespace {

void pair_with_impulse(Case& c, const Format& format) {
  c.dimension = whole(2, 4);
  const Masses m = masses(format);
  c.hazard = std::isinf(m.A) || std::isinf(m.B) ? "infinite_mass"
             : m.A == m.B                       ? "equal_masses"
                                                : "finite_masses";
  c.set(m);
  for (const char* key : {"v_A", "v_B", "dp"}) c.set(key, vector(format, c.dimension));
}

/// |Δp| + μ|v_AB|.
Wide momenta(const Case& c) {
  return norm(wide(c.vector("dp"))) +
         reduced_mass(c.masses()) * norm(wide(c.vector("v_B")) - wide(c.vector("v_A")));
}

// Eq. (6) errs by 5u of the speeds, eq. (7) by 6u (|Δp| + μ|v_AB|), each eq. (3) by 2u of Δp/m and 1u of v';
// what is passed on is rounded.
Outcome load_and_restitution_are_the_collision(Interview& ask, const Case& c) {
  const Masses m = c.masses();
  const Vec3 v_A = c.vector("v_A"), v_B = c.vector("v_B"), dp = c.vector("dp");
  const Vec3 v = ask.passed(ask.load(m, v_A, v_B));
  const Vec3 dp_AB = ask.passed(ask.restitution_impulse(m, v_A, v_B, dp));
  const Velocities grouped = ask.apply_impulse(m, v, v, dp_AB);
  const Velocities at_once = ask.apply_impulse(m, v_A, v_B, dp);
  const Wide u = ask.u(), u_passed = ask.u_passed();
  const Wide speeds = norm(wide(v_A)) + norm(wide(v_B));
  const auto agree = [&](const char* what, double mass, const WideVector& x, const WideVector& y) {
    const Wide rounding = (5 * u + u_passed) * speeds +
                          (10 * u + u_passed) * momenta(c) * inverse_mass(mass) + u * (norm(x) + norm(y));
    return at_most(what, norm(x - y), rounding * kSlack);
  };
  return all_of(agree("grouped and at once v_A' differ, which", m.A, grouped.v_A, at_once.v_A),
                agree("grouped and at once v_B' differ, which", m.B, grouped.v_B, at_once.v_B));
}

// With e₆ and e₇ the errors of (6) and (7) the two energies err by M|v_load|e₆ + M e₆²/2 and |Δp_AB|e₇/μ +
// e₇²/2μ.
Outcome the_energy_kept(Interview& ask, const Case& c) {
  const Masses m = c.masses();
  if (std::isinf(m.A) || std::isinf(m.B)) return outside("an infinite mass has any energy");
  const Wide m_A(m.A), m_B(m.B), mu = reduced_mass(m), M = m_A + m_B;
  const WideVector v_A = wide(c.vector("v_A")), v_B = wide(c.vector("v_B")), dp = wide(c.vector("dp"));
  const WideVector v = ask.load(m, c.vector("v_A"), c.vector("v_B"));
  const WideVector dp_AB = ask.restitution_impulse(m, c.vector("v_A"), c.vector("v_B"), c.vector("dp"));
  const WideVector new_A = v_A + dp / m_A, new_B = v_B - dp / m_B;
  const Wide parted = (m_A * dot(new_A, new_A) + m_B * dot(new_B, new_B)) / 2;
  const Wide together = M * dot(v, v) / 2;
  const Wide kept = dot(dp_AB, dp_AB) / (2 * mu);
  const Wide e_6 = 5 * ask.u() * (m_A * norm(v_A) + m_B * norm(v_B)) / M;
  const Wide e_7 = 6 * ask.u() * momenta(c);
  const Wide bound = M * e_6 * (norm(v) + e_6) + e_7 * (norm(dp_AB) + e_7) / mu;
  return at_most("the energy that is missing", abs(Wide(parted - together - kept)), bound * kSlack);
}

Outcome the_impulse_is_opposite(Interview& ask, const Case& c) {
  const Vec3 dp = c.vector("dp");
  return same_to("Δp_AB with the names exchanged",
                 opposite(ask.restitution_impulse(swapped(c.masses()), c.vector("v_B"), c.vector("v_A"),
                                                  {0 - dp[0], 0 - dp[1], 0 - dp[2]})),
                 ask.restitution_impulse(c.masses(), c.vector("v_A"), c.vector("v_B"), dp),
                 2 * 6 * ask.u() * momenta(c) * kSlack);
}

}  // namespace

void add_laws(std::vector<Law>& laws) {
  const std::string page = "docs/eq7.md";
  laws.push_back({{"Eq7Laws.Law1LoadAndRestitutionAreTheCollision", "(7) law 1",
                   "(6) and (7) with (3) give the velocities of (3) with Δp alone, to rounding", page},
                  {Op::load, Op::restitution_impulse, Op::apply_impulse},
                  cases(pair_with_impulse),
                  load_and_restitution_are_the_collision});
  laws.push_back({{"Eq7Laws.Law2TheEnergyKept", "(7) law 2",
                   "loading keeps |Δp_AB|²/2μ of the kinetic energy that (3) would leave", page},
                  {Op::load, Op::restitution_impulse},
                  cases(pair_with_impulse),
                  the_energy_kept});
  laws.push_back({{"Eq7Laws.Law3TheImpulseIsOppositeForTheOther", "(7) law 3",
                   "exchanging A and B flips Δp_AB, bitwise", page},
                  {Op::restitution_impulse},
                  cases(pair_with_impulse),
                  the_impulse_is_opposite});
}

}  // namespace tps::properties::eq7
