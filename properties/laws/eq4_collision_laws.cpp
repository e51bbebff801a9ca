// Eq. (4), docs/eq4.md.
#include "properties/generators/cases.hpp"
#include "properties/generators/numbers.hpp"
#include "properties/generators/pairs.hpp"
#include "properties/law.hpp"
#include "properties/laws/response_errors.hpp"

namespace tps::properties::eq4 {
namespace {

void colliding_pair(Case& c, const Format& format) {
  put_pair(c, format);
  c.numbers.erase("L");
  c.set(masses(format));
  c.set("c", coefficient(format));
}

void with_powers(Case& c, const Format& format) {
  colliding_pair(c, format);
  const int most = format.largest_case_exponent() / 2;
  for (const char* key : {"power_of_lengths", "power_of_speeds", "power_of_masses"})
    c.set(key, whole(-most, most + 1));
}

/// The response of a case: relative velocity afterwards, v_AB − Δp/μ, exactly from the Δp that was answered.
struct Rebound {
  Rebound(Interview& ask, const Case& c)
      : x(c.pair()),
        c_rebound(c.number("c")),
        after(x.v - ask.collision_impulse(c.pair(), c.masses(), c.number("c")) / reduced_mass(c.masses())),
        error(collision_error(x, c.number("c"), ask.u())) {}

  Encounter x;
  Wide c_rebound;
  WideVector after;
  Wide error;
};

Outcome normal_turns_and_tangential_stays(Interview& ask, const Case& c) {
  const Rebound k(ask, c);
  const WideVector expected = k.x.v - ((1 + k.c_rebound) * k.x.v_n) * k.x.n;
  return at_most("the error of v_AB'", norm(k.after - expected), k.error);
}

/// What rounding does to Δp, twice: once for each of two answers. Refuses a pair at one point, to which eq.
/// (4) has no answer.
Wide twice_the_rounding(Interview& ask, const Case& c) {
  return 2 * reduced_mass(c.masses()) * collision_error(Encounter(c.pair()), c.number("c"), ask.u());
}

Outcome the_impulse_is_opposite(Interview& ask, const Case& c) {
  const Wide rounding = twice_the_rounding(ask, c);
  return same_to("Δp with the names exchanged",
                 opposite(ask.collision_impulse(swapped(c.pair()), swapped(c.masses()), c.number("c"))),
                 ask.collision_impulse(c.pair(), c.masses(), c.number("c")), rounding);
}

Outcome energy_falls(Interview& ask, const Case& c) {
  const Rebound k(ask, c);
  const Wide lost = (dot(k.x.v, k.x.v) - dot(k.after, k.after)) / 2;
  const Wide expected = (1 - k.c_rebound * k.c_rebound) * k.x.v_n * k.x.v_n / 2;
  return at_most("the error of the energy lost, by μ", abs(Wide(lost - expected)),
                 k.error * (k.x.speed + k.error));
}

Outcome angular_momentum_is_conserved(Interview& ask, const Case& c) {
  const Rebound k(ask, c);
  return at_most("|r × Δp|, by μ", norm(cross(k.x.r, k.after - k.x.v)), k.error * k.x.distance);
}

Outcome powers_of_two(Interview& ask, const Case& c) {
  const Wide rounding = twice_the_rounding(ask, c);
  const int speeds = c.integer("power_of_speeds"), of_masses = c.integer("power_of_masses");
  const Masses m = c.masses();
  const WideVector dp =
      ask.collision_impulse(scaled(c.pair(), c.integer("power_of_lengths"), speeds),
                            {std::ldexp(m.A, of_masses), std::ldexp(m.B, of_masses)}, c.number("c"));
  return same_to("Δp of scaled numbers, scaled back", ldexp(Wide(1), -speeds - of_masses) * dp,
                 ask.collision_impulse(c.pair(), m, c.number("c")), rounding);
}

}  // namespace

void add_laws(std::vector<Law>& laws) {
  const std::string page = "docs/eq4.md";
  const std::vector<Op> operation{Op::collision_impulse};
  laws.push_back({{"Eq4Laws.Law1NormalVelocityTurnsByCAndTangentialStays", "(4) law 1",
                   "afterwards v_n' = −c v_n along û and v_ŵ' = v_ŵ across it, to 20u (1 + c)|v_AB|", page},
                  operation,
                  cases(colliding_pair),
                  normal_turns_and_tangential_stays});
  laws.push_back({{"Eq4Laws.Law2TheImpulseIsOppositeForTheOther", "(4) law 2",
                   "momentum is conserved: exchanging A and B flips Δp, bitwise", page},
                  operation,
                  cases(colliding_pair),
                  the_impulse_is_opposite});
  laws.push_back({{"Eq4Laws.Law3EnergyFallsByTheShareOfRestitution", "(4) law 3",
                   "the kinetic energy falls by ½ μ (1 − c²) v_n²", page},
                  operation,
                  cases(colliding_pair),
                  energy_falls});
  laws.push_back({{"Eq4Laws.Law4AngularMomentumIsConserved", "(4) law 4",
                   "angular momentum is conserved: Δp is along û", page},
                  operation,
                  cases(colliding_pair),
                  angular_momentum_is_conserved});
  laws.push_back(
      {{"Eq4Laws.Law5PowersOfTwo", "(4) law 5",
        "lengths times 2^k change nothing, velocities or masses times 2^k multiply Δp by 2^k, bitwise", page},
       operation,
       cases(with_powers),
       powers_of_two});
}

}  // namespace tps::properties::eq4
