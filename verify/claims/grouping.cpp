// X-Y-Z grouped: two collisions instead of 70, with the velocities that eqs. (6) and (7) give.
#include <fmt/format.h>

#include <array>
#include <limits>

#include "verify/claims/claim.hpp"
#include "verify/claims/runs.hpp"

namespace tps::claims {
namespace {

constexpr double kGap = 0.015625;
constexpr double kLongEnough = 0.0625;

ThreeBodyParams grouped(double dt_restitute, double c) {
  ThreeBodyParams params;
  params.gap = kGap;
  params.restitution = c;
  params.grouped = dt_restitute;
  return params;
}

/// Collisions that real arithmetic has too.
long long true_collisions(const RunSummary& s) {
  return count(s, "rebound") - static_cast<long long>(s.noise);
}

void add_velocities(Claim& claim, double c, const std::array<double, 3>& expected,
                    const std::string& fractions) {
  const RunSummary run = run_three_body(grouped(kLongEnough, c));
  claim.figures.push_back(
      exactly(fmt::format("collisions, c = {}", c), 2, "X-Y, then XY-Z", true_collisions(run)));
  claim.figures.push_back(
      exactly(fmt::format("restitutions, c = {}", c), 2, "one a collision", count(run, "restitute")));
  for (std::size_t i = 0; i < 3; ++i) {
    // The path of a velocity has two loads and two restitutions of a dozen roundings each, of numbers up to
    // 1; m_Y and c are within half an ulp of the decimals.
    constexpr double kTolerance = 48 * std::numeric_limits<double>::epsilon() / 2;
    claim.figures.push_back(within(fmt::format("velocity of {}, c = {}", "XYZ"[i], c), expected[i],
                                   kTolerance, fractions, std::stod(final_vx(run, i)), 12));
  }
}

}  // namespace

Claim grouping() {
  Claim claim{"grouping",
              "Grouped, the 70 collisions become 2, and momentum is conserved.",
              "Nearly-simultaneous collisions",
              scene_and_run("three-body --grouped 0.0625", "grouped"),
              {}};
  add_velocities(claim, 1, {-1.0 / 2001, 2000.0 / 2001, 2000.0 / 2001},
                 "(6), (7) with m_Y = 1/1000: −1/2001, 2000/2001, 2000/2001");
  add_velocities(claim, 0.9, {991.0 / 20010, 1900.0 / 2001, 1900.0 / 2001},
                 "(6), (7) with m_Y = 1/1000: 991/20010, 1900/2001, 1900/2001");
  // X and Y move on with v_load = 1/(1 + m_Y); Y reaches Z gap/v_load after it met X.
  const double needed = kGap * (1 + 0.001);
  const RunSummary longer = run_three_body(grouped(needed * 1.001, 1));
  claim.figures.push_back(exactly(fmt::format("collisions, dt_restitute {:.6g}", needed * 1.001), 2,
                                  fmt::format("above gap/v_load = {:.6g}", needed), true_collisions(longer)));
  const RunSummary shorter = run_three_body(grouped(needed * 0.999, 1));
  claim.figures.push_back(same(fmt::format("more than 2 collisions, dt_restitute {:.6g}", needed * 0.999),
                               "yes", "below gap/v_load: X-Y part before Y meets Z",
                               true_collisions(shorter) > 2 ? "yes" : "no"));
  claim.figures.push_back(same("end below e_c (c = 0.89), grouped", "duration",
                               "a grouped scene cannot stall",
                               run_three_body(grouped(kLongEnough, 0.89)).end));
  return claim;
}

}  // namespace tps::claims
