// Eq. (5), docs/eq5.md.
#include "properties/generators/cases.hpp"
#include "properties/generators/numbers.hpp"
#include "properties/generators/pairs.hpp"
#include "properties/law.hpp"
#include "properties/laws/response_errors.hpp"

namespace tps::properties::eq5 {
namespace {

void revolving_pair(Case& c, const Format& format) {
  put_pair(c, format);
  c.numbers.erase("L");
  c.set(masses(format));
  c.set("c_revolve", coefficient(format));
  c.set("theta_revolve_deg", revolve_angle(format));
}

void with_powers(Case& c, const Format& format) {
  revolving_pair(c, format);
  const int most = format.largest_case_exponent() / 2;
  for (const char* key : {"power_of_lengths", "power_of_speeds", "power_of_masses"})
    c.set(key, whole(-most, most + 1));
}

Encounter turning_encounter(const Case& c) {
  Encounter x(c.pair());
  if (!turns(x)) throw Unanswered{outside("hardly any motion across the axis")};
  return x;
}

/// What rounding does to Δp, twice: once for each of two answers.
Wide twice_the_rounding(Interview& ask, const Case& c) {
  return 2 * reduced_mass(c.masses()) * revolution_error(turning_encounter(c), ask.u());
}

WideVector impulse(Interview& ask, const Case& c, const PairState& pair, const Masses& m) {
  return ask.revolution_impulse(pair, m, c.number("c_revolve"), c.number("theta_revolve_deg"));
}

struct Turn {
  Turn(Interview& ask, const Case& c)
      : x(turning_encounter(c)),
        angle(radians(c.number("theta_revolve_deg"))),
        ratio(speed_ratio(c.number("c_revolve"), c.number("theta_revolve_deg"))),
        after(x.v - impulse(ask, c, c.pair(), c.masses()) / reduced_mass(c.masses())),
        error(revolution_error(x, ask.u())) {}

  Encounter x;
  Wide angle, ratio;
  WideVector after;
  Wide error;
};

Outcome closes_at_theta(Interview& ask, const Case& c) {
  const Turn k(ask, c);
  const Wide normal = dot(k.after, k.x.n);
  const Wide tangential = norm(k.after - normal * k.x.n);
  return all_of(
      at_most("v_n' cos θ + |v_ŵ'| sin θ", abs(Wide(normal * cos(k.angle) + tangential * sin(k.angle))),
              2 * k.error),
      at_most("the error of v_AB', which keeps the sense of v_ŵ",
              norm(k.after - revolved(k.x, c.number("c_revolve"), c.number("theta_revolve_deg"))), k.error));
}

Outcome speed_falls_by_the_ratio(Interview& ask, const Case& c) {
  const Turn k(ask, c);
  return at_most("the error of |v_AB'|", abs(Wide(norm(k.after) - k.ratio * k.x.speed)), k.error);
}

Outcome the_impulse_is_opposite(Interview& ask, const Case& c) {
  const Wide rounding = twice_the_rounding(ask, c);
  return same_to("Δp with the names exchanged",
                 opposite(impulse(ask, c, swapped(c.pair()), swapped(c.masses()))),
                 impulse(ask, c, c.pair(), c.masses()), rounding);
}

Outcome energy_falls(Interview& ask, const Case& c) {
  const Turn k(ask, c);
  const Wide before = dot(k.x.v, k.x.v);
  const Wide lost = (before - dot(k.after, k.after)) / 2;
  return at_most("the error of the energy lost, by μ", abs(Wide(lost - (1 - k.ratio * k.ratio) * before / 2)),
                 k.error * (k.x.speed + k.error));
}

Outcome powers_of_two(Interview& ask, const Case& c) {
  const Wide rounding = twice_the_rounding(ask, c);
  const int speeds = c.integer("power_of_speeds"), of_masses = c.integer("power_of_masses");
  const Masses m = c.masses();
  const WideVector dp = impulse(ask, c, scaled(c.pair(), c.integer("power_of_lengths"), speeds),
                                {std::ldexp(m.A, of_masses), std::ldexp(m.B, of_masses)});
  return same_to("Δp of scaled numbers, scaled back", ldexp(Wide(1), -speeds - of_masses) * dp,
                 impulse(ask, c, c.pair(), m), rounding);
}

}  // namespace

void add_laws(std::vector<Law>& laws) {
  const std::string page = "docs/eq5.md";
  const std::vector<Op> operation{Op::revolution_impulse};
  laws.push_back({{"Eq5Laws.Law1ClosesAtThetaFromPerpendicular", "(5) law 1",
                   "afterwards the pair closes at exactly θ from perpendicular, in the sense of v_ŵ", page},
                  operation,
                  cases(revolving_pair),
                  closes_at_theta});
  laws.push_back({{"Eq5Laws.Law2SpeedFallsByTheRatioOfOneCollision", "(5) law 2",
                   "the relative speed falls by the factor c_revolve^(θ/π)", page},
                  operation,
                  cases(revolving_pair),
                  speed_falls_by_the_ratio});
  laws.push_back({{"Eq5Laws.Law3TheImpulseIsOppositeForTheOther", "(5) law 3",
                   "momentum is conserved: exchanging A and B flips Δp, bitwise", page},
                  operation,
                  cases(revolving_pair),
                  the_impulse_is_opposite});
  laws.push_back({{"Eq5Laws.Law4EnergyFallsByTheSquareOfTheRatio", "(5) law 4",
                   "the kinetic energy falls by ½ μ (1 − c_revolve^(2θ/π)) |v_AB|²", page},
                  operation,
                  cases(revolving_pair),
                  energy_falls});
  laws.push_back(
      {{"Eq5Laws.Law5PowersOfTwo", "(5) law 5",
        "lengths times 2^k change nothing, velocities or masses times 2^k multiply Δp by 2^k, bitwise", page},
       operation,
       cases(with_powers),
       powers_of_two});
}

}  // namespace tps::properties::eq5
