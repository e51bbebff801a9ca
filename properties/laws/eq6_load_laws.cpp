// Eq. (6), docs/eq6.md.
#include <algorithm>
#include <array>

#include "properties/generators/cases.hpp"
#include "properties/generators/numbers.hpp"
#include "properties/law.hpp"
#include "properties/laws/compare.hpp"

namespace tps::properties::eq6 {
namespace {

void loaded_pair(Case& c, const Format& format) {
  c.dimension = whole(2, 4);
  const Masses m = masses(format);
  c.hazard = std::isinf(m.A) || std::isinf(m.B) ? "infinite_mass"
             : m.A == m.B                       ? "equal_masses"
                                                : "finite_masses";
  c.set(m);
  for (const char* key : {"v_A", "v_B"}) c.set(key, vector(format, c.dimension));
}

std::array<Wide, 3> loaded(Interview& ask, const Case& c) {
  return components(ask.load(c.masses(), c.vector("v_A"), c.vector("v_B")));
}

// A weight errs by 3u (ratio, sum, inverse), its product by 1u, the sum by 1u.
Outcome momentum_of_the_pair(Interview& ask, const Case& c) {
  const Masses m = c.masses();
  if (std::isinf(m.A) || std::isinf(m.B)) return outside("an infinite mass has any momentum");
  const auto v_A = components(wide(c.vector("v_A"))), v_B = components(wide(c.vector("v_B")));
  const auto v = loaded(ask, c);
  Outcome outcome;
  for (std::size_t k = 0; k < 3; ++k) {
    const Wide A = Wide(m.A) * v_A[k], B = Wide(m.B) * v_B[k];
    outcome = all_of(
        outcome, at_most("the error of (m_A + m_B) v_load", abs(Wide((Wide(m.A) + Wide(m.B)) * v[k] - A - B)),
                         5 * ask.u() * (abs(A) + abs(B)) * kSlack));
  }
  return outcome;
}

Outcome between_the_two(Interview& ask, const Case& c) {
  const auto v_A = components(wide(c.vector("v_A"))), v_B = components(wide(c.vector("v_B")));
  const auto v = loaded(ask, c);
  Outcome outcome;
  for (std::size_t k = 0; k < 3; ++k) {
    const Wide rounding = 5 * ask.u() * std::max(abs(v_A[k]), abs(v_B[k])) * kSlack;
    outcome = all_of(outcome, at_most("v_load above both by", v[k] - std::max(v_A[k], v_B[k]), rounding),
                     at_most("v_load below both by", std::min(v_A[k], v_B[k]) - v[k], rounding));
  }
  return outcome;
}

/// 5u of the speeds, as above.
Wide rounding(Interview& ask, const Case& c) {
  return 5 * ask.u() * (norm(wide(c.vector("v_A"))) + norm(wide(c.vector("v_B")))) * kSlack;
}

Outcome swap_of_names(Interview& ask, const Case& c) {
  return same_to("v_load with the names exchanged",
                 ask.load(swapped(c.masses()), c.vector("v_B"), c.vector("v_A")),
                 ask.load(c.masses(), c.vector("v_A"), c.vector("v_B")), 2 * rounding(ask, c));
}

Outcome an_infinite_mass_takes_the_other_along(Interview& ask, const Case& c) {
  const Masses m = c.masses();
  if (!std::isinf(m.A) && !std::isinf(m.B)) return outside("both masses are finite");
  return same_to("v_load, and the velocity of the infinite mass",
                 ask.load(m, c.vector("v_A"), c.vector("v_B")),
                 wide(c.vector(std::isinf(m.A) ? "v_A" : "v_B")), rounding(ask, c));
}

}  // namespace

void add_laws(std::vector<Law>& laws) {
  const auto add = [&laws](const char* id, const char* number, const char* sentence, const auto& check) {
    laws.push_back({{id, number, sentence, "docs/eq6.md"}, {Op::load}, cases(loaded_pair), check});
  };
  add("Eq6Laws.Law1MomentumOfThePairIsThatOfTheGroup", "(6) law 1",
      "(m_A + m_B) v_load = m_A v_A + m_B v_B, to 5u of the terms", momentum_of_the_pair);
  add("Eq6Laws.Law2BetweenTheTwoVelocities", "(6) law 2",
      "each component of v_load is between those of v_A and v_B, to rounding", between_the_two);
  add("Eq6Laws.Law3SwapOfNames", "(6) law 3", "A and B may be exchanged, bitwise", swap_of_names);
  add("Eq6Laws.Law4AnInfiniteMassTakesTheOtherAlong", "(6) law 4",
      "with an infinite mass v_load is its velocity, bitwise", an_infinite_mass_takes_the_other_along);
}

}  // namespace tps::properties::eq6
