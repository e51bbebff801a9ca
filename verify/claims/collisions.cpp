// X-Y-Z with a Y of a thousandth of the mass collide 70 times.
#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "reference/scalars.hpp"
#include "verify/claims/claim.hpp"
#include "verify/claims/runs.hpp"
#include "verify/claims/three_on_a_line.hpp"

namespace tps::claims {
namespace {

/// Elastic collisions are rotations of (√m_X v_X, √m_Y v_Y, √m_Z v_Z), a vector of length 1, so errors add up
/// and do not grow: (3) and (4) round 16 times at most, by ε/2 each, hence 8 ε a collision.
double velocity_tolerance(int collisions, double mass, double epsilon) {
  return collisions * 8 * epsilon / std::sqrt(mass);
}

void add_velocities(Claim& claim, const ThreeBodyParams& params, const RunSummary& run,
                    const std::string& scalar, double epsilon) {
  const Counted truth = count_one_by_one(params.middle_mass, 1);
  const std::array<double, 3> masses{1, params.middle_mass, 1};
  for (std::size_t i = 0; i < 3; ++i) {
    const double tolerance = velocity_tolerance(truth.collisions, masses[i], epsilon);
    claim.figures.push_back({fmt::format("final velocity of {}, {}", "XYZ"[i], scalar),
                             fmt::format("{:.12f} ± {:.1g}", std::stod(truth.velocities[i]), tolerance),
                             "70 collisions one by one in 300 digits; errors of rotations add up",
                             fmt::format("{:.12f}", std::stod(final_vx(run, i))),
                             difference(final_vx(run, i), truth.velocities[i]) <= tolerance});
  }
}

}  // namespace

Claim collisions() {
  Claim claim{"collisions",
              "With Y a thousandth as heavy as X and Z, and c = 1, there are 70 collisions.",
              "Nearly-simultaneous collisions",
              scene_and_run("three-body", "three-body"),
              {}};
  const ThreeBodyParams params;
  const RunSummary in_double = run_three_body(params);
  const RunSummary in_mp50 = run_three_body(params, ScalarKind::mp50);
  claim.figures.push_back(exactly("collisions, double", 70, "the paper", count(in_double, "rebound")));
  claim.figures.push_back(exactly("collisions, mp50", 70, "the paper", count(in_mp50, "rebound")));
  add_velocities(claim, params, in_double, "double", std::numeric_limits<double>::epsilon());
  add_velocities(claim, params, in_mp50, "mp50", static_cast<double>(std::numeric_limits<Mp50>::epsilon()));
  for (const double mass : {1.0, 0.1, 0.01, 0.001, 1e-4, 1e-6}) {
    ThreeBodyParams other;
    other.middle_mass = mass;
    claim.figures.push_back(exactly("collisions for m_Y = " + text(mass), collisions_by_formula(mass, 1),
                                    "⌈π/φ⌉ − 1, cos φ = 1/(1 + m_Y)",
                                    count(run_three_body(other), "rebound")));
  }
  return claim;
}

}  // namespace tps::claims
