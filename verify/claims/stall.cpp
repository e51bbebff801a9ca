// X-Y-Z with inelastic collisions: ever more of them down to e_c, then a collapse; and where each scalar
// gives up before.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "reference/scalars.hpp"
#include "verify/claims/claim.hpp"
#include "verify/claims/runs.hpp"
#include "verify/claims/three_on_a_line.hpp"

namespace tps::claims {
namespace {

constexpr double kMiddle = 0.001;

ThreeBodyParams at(double e) {
  ThreeBodyParams params;
  params.middle_mass = kMiddle;
  params.restitution = e;
  return params;
}

std::string power_of_ten(double log10) {
  const double exponent = std::floor(log10);
  return fmt::format("{:.2f}e{:.0f}", std::pow(10, log10 - exponent), exponent);
}

/// Approach speed of the last collision of a run, from the velocities before it.
double last_approach(double e, ScalarKind scalar, int collisions) {
  const RunSummary before = run_three_body(at(e), scalar, static_cast<std::uint64_t>(collisions - 1));
  // Odd collisions are of X and Y.
  const std::size_t left = collisions % 2 == 1 ? 0 : 1;
  return difference(final_vx(before, left), final_vx(before, left + 1));
}

/// The c_rebound between stall and end of run, to a hundredth of its distance from e_c.
double bisect(ScalarKind scalar, double expected) {
  const double e_c = collapse_restitution(kMiddle);
  double stalls = e_c + (expected - e_c) / 2;
  double ends = e_c + (expected - e_c) * 2;
  while (ends - stalls > (expected - e_c) / 100) {
    const double middle = stalls + (ends - stalls) / 2;
    (run_three_body(at(middle), scalar).end == "stalled" ? stalls : ends) = middle;
  }
  return ends;
}

template <typename Scalar>
Figure threshold(const std::string& name, ScalarKind scalar) {
  // Rounding errors live on for 1/(1 − √e) = 23 collisions before they are damped away, and velocities near
  // 1/2 have half or a quarter of ε as their ulp: the speed that is lost in noise is ε times or by 16.
  constexpr double kNoise = 16;
  const double log10_epsilon =
      static_cast<double>(Scalar(log10(Scalar(std::numeric_limits<Scalar>::epsilon()))));
  const auto where = [&](double factor) {
    return restitution_where_speeds_reach(kMiddle, log10_epsilon + std::log10(factor));
  };
  const double expected = where(1);
  return between(
      "smallest c that ends, " + name, where(1 / kNoise), where(kNoise),
      "e^(π/2φ) = ε·16 or ε/16; e_c + " + fmt::format("{:.2g}", expected - collapse_restitution(kMiddle)),
      bisect(scalar, expected), name == "double" ? 5 : 8);
}

void add_counts(Claim& claim, const Counted& beyond) {
  for (const double e : {0.99, 0.98, 0.96, 0.95, 0.94, 0.93, 0.92, 0.915}) {
    claim.figures.push_back(same("collisions at c = " + text(e) + ", double",
                                 std::to_string(collisions_by_formula(kMiddle, e)), "⌈π/φ⌉ − 1",
                                 count_or_stall(run_three_body(at(e)))));
  }
  claim.figures.push_back(same("collisions at c = 0.9145, mp50",
                               std::to_string(collisions_by_formula(kMiddle, 0.9145)), "⌈π/φ⌉ − 1",
                               count_or_stall(run_three_body(at(0.9145), ScalarKind::mp50))));
  claim.figures.push_back(same("collisions at c = 0.91445, 300 digits",
                               std::to_string(collisions_by_formula(kMiddle, 0.91445)),
                               "⌈π/φ⌉ − 1; one by one, since no scalar of the engine reaches that far",
                               std::to_string(beyond.collisions)));
}

void add_smallest_speeds(Claim& claim, const Counted& beyond) {
  constexpr const char* kFormula = "e^((n−1)/2) sin(nφ)/sin φ";
  const auto add = [&](const std::string& name, double e, double measured_log10) {
    const double expected = last_approach_by_formula(kMiddle, e);
    claim.figures.push_back({name, power_of_ten(expected), kFormula, power_of_ten(measured_log10),
                             power_of_ten(expected) == power_of_ten(measured_log10)});
  };
  add("last approach speed at c = 0.92, double", 0.92,
      std::log10(last_approach(0.92, ScalarKind::double_, 194)));
  add("last approach speed at c = 0.9145, mp50", 0.9145,
      std::log10(last_approach(0.9145, ScalarKind::mp50, 1960)));
  add("last approach speed at c = 0.91445, 300 digits", 0.91445, beyond.log10_smallest_approach);
}

}  // namespace

Claim stall() {
  Claim claim{"stall",
              "With c below 0.9 the same scene stalls: impulses converge to zero.",
              "Nearly-simultaneous collisions",
              scene_and_run("three-body --restitution 0.89", "inelastic"),
              {}};
  const double e_c = collapse_restitution(kMiddle);
  claim.figures.push_back(within("bound of collapse e_c", 0.9144475, 5e-8,
                                 "(1 − sin α)/(1 + sin α), cos α = 1/(1 + m_Y)", e_c, 7));
  const std::array<std::pair<const char*, ScalarKind>, 2> scalars{
      {{"double", ScalarKind::double_}, {"mp50", ScalarKind::mp50}}};
  for (const double e : {0.89, 0.9, 0.9144}) {
    for (const auto& [name, scalar] : scalars) {
      claim.figures.push_back(same(fmt::format("end at c = {}, {}", e, name), "stalled",
                                   "c ≤ e_c: a collapse", run_three_body(at(e), scalar).end));
    }
  }
  const Counted beyond = count_one_by_one(kMiddle, 0.91445);
  add_counts(claim, beyond);
  claim.figures.push_back(same("end at c = 0.9145, double", "stalled",
                               "1960 collisions in truth, but speeds fall to 1e-38",
                               run_three_body(at(0.9145)).end));
  claim.figures.push_back(same("end at c = 0.91445, mp100", "stalled",
                               "8913 collisions in truth, but speeds fall to 1e-174",
                               run_three_body(at(0.91445), ScalarKind::mp100).end));
  add_smallest_speeds(claim, beyond);
  claim.figures.push_back(threshold<double>("double", ScalarKind::double_));
  claim.figures.push_back(threshold<Mp50>("mp50", ScalarKind::mp50));
  claim.figures.push_back(threshold<Mp100>("mp100", ScalarKind::mp100));
  return claim;
}

}  // namespace tps::claims
