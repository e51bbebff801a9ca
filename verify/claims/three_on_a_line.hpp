// X, Y and Z on a line in real arithmetic: what their collisions must be, without the engine.
#pragma once

#include <array>
#include <string>

namespace tps::claims {

// X and Z have mass 1, Y has mass m; X comes with velocity 1, Y and Z rest; c_rebound = e for both pairs.
//
// The pairs X-Y and Y-Z collide in turn. Let g_k be the approach speed of collision k. A collision turns g_k
// into a separation e g_k, and Y's new velocity changes the other pair's approach by (1 + e) a g_k with
// a = 1/(1 + m). Hence
//
//   g_(k+1) = (1 + e) a g_k − e g_(k−1),   g_0 = 0, g_1 = 1,
//   g_k = e^((k−1)/2) sin(kφ)/sin φ,       cos φ = (1 + e) a/(2 √e),
//
// and the collisions are those k ≥ 1 up to the first g_k that is not positive: n = ⌈π/φ⌉ − 1. Where the
// cosine reaches 1 there is no last one (collapse): e_c = (1 − sin α)/(1 + sin α) with cos α = a. Gaps decide
// when a collision happens, not whether; the numbers do not depend on them.

/// e_c: collisions never end for 0 < e <= e_c.
double collapse_restitution(double middle_mass);

/// n by the formula, in 200 digits. REQUIRES e > e_c.
int collisions_by_formula(double middle_mass, double e);

/// log10 of g_n, the approach speed of the last collision, by the formula. REQUIRES e > e_c.
double last_approach_by_formula(double middle_mass, double e);

/// The c_rebound where e^(n/2) = smallest, n = π/φ: below it, approach speeds fall under what a scalar of
/// that relative precision can tell from zero. Solved by bisection to all digits of a double.
double restitution_where_speeds_reach(double middle_mass, double log10_smallest);

/// The collisions carried out one by one on three velocities with 300 digits: no formula of a wedge, no gap.
struct Counted {
  int collisions = 0;
  double log10_smallest_approach = 0;
  std::array<std::string, 3> velocities;  ///< 60 digits
};
Counted count_one_by_one(double middle_mass, double e);

/// |x − y| of two decimal numbers, taken with 300 digits.
double difference(const std::string& x, const std::string& y);

}  // namespace tps::claims
