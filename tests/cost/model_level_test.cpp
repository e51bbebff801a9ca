// What Δt_restitute and θ_revolve buy and cost, against what eqs. (5) to (7) say without the engine
// (docs/accuracy-cost.md, "The model's own numbers").
#include "verify/cost/model_level.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tps::cost {
namespace {

constexpr double kUnit = 0x1p-53;

class Grouping : public testing::Test {
 protected:
  static void SetUpTestSuite() { measure_grouping(level_, {}); }

  static std::vector<GroupingRow> rows_of(const std::string& scene) {
    std::vector<GroupingRow> rows;
    std::copy_if(level_.grouping.begin(), level_.grouping.end(), std::back_inserter(rows),
                 [&](const GroupingRow& row) { return row.scene == scene; });
    EXPECT_GE(rows.size(), 20U);
    return rows;
  }

  static ModelLevel level_;
};

ModelLevel Grouping::level_;

/// X and Y move at v_load = 1/(1 + m_Y) and reach Z gap/v_load later, so 0.01564 decides whether one group
/// takes all three. Below the shortest time between collisions nothing is saved, and nothing is changed.
TEST_F(Grouping, OfXYZSavesCollisionsOrKeepsTheTruthAndNeverBoth) {
  const double needed = 0.015625 * 1.001;
  for (const GroupingRow& row : rows_of("three-body")) {
    ASSERT_TRUE(row.distance);
    EXPECT_EQ(row.events, 2 * row.collisions) << "a restitution for each load";
    EXPECT_EQ(row.collisions == 2, row.dt_restitute > needed) << row.dt_restitute;
    if (row.collisions < 70) {
      // Whenever collisions are saved Y leaves with Z, at 2000/2001; in the truth it is slower than .73.
      EXPECT_GT(*row.distance, 2000.0 / 2001 - 0.73) << row.dt_restitute;
      EXPECT_EQ(row.largest_group, 3U);
      EXPECT_TRUE(row.horizon);
    } else {
      // Each of 140 events rounds velocities below 2 a dozen times; Y's is the lightest, and m_Y = 1/1000
      // amplifies an impulse's rounding by at most 2 in v_Y.
      EXPECT_LT(*row.distance, 140 * 12 * 4 * kUnit) << row.dt_restitute;
      EXPECT_EQ(row.largest_group, 2U);
      EXPECT_FALSE(row.horizon);
    }
  }
}

/// Below e_c the ungrouped run stalls; grouped with anything that a time can tell it ends, after ever more
/// collisions the smaller Δt_restitute is.
TEST_F(Grouping, EndsACollapseUntilItVanishesBesideTheClock) {
  std::uint64_t before = 0;
  for (const GroupingRow& row : rows_of("collapse")) {
    EXPECT_GE(row.collisions, before) << row.dt_restitute;
    before = row.collisions;
    // The low part of the clock, a sum of two doubles, is below 2^-53; its ulp may be far below 2^-106 =
    // 1e-32.
    EXPECT_EQ(row.end, row.dt_restitute > 1e-40 ? "duration" : "stalled") << row.dt_restitute;
    if (row.end == "duration") {
      EXPECT_LT(row.collisions, 100U);
    }
  }
}

/// Five equal balls that touch are one group for any Δt_restitute. The fifth is loaded to 1/5 and given 1/5
/// more when the root is restituted: 2/5 where the truth is 1.
TEST_F(Grouping, OfTouchingBallsIsAsFarFromTheTruthHoweverShort) {
  for (const GroupingRow& row : rows_of("cradle")) {
    ASSERT_TRUE(row.distance);
    if (row.dt_restitute < 1e-17) continue;  // gaps of an ulp of 0.1 are longer than that
    EXPECT_EQ(row.largest_group, 5U);
    EXPECT_NEAR(*row.distance, 0.6, 8 * 12 * kUnit) << row.dt_restitute;
  }
}

/// c_rebound = 1 and c_retract = 1: loads store what restitutions give back.
TEST_F(Grouping, KeepsTheEnergyOfElasticScenes) {
  for (const char* scene : {"three-body", "cradle"}) {
    for (const GroupingRow& row : rows_of(scene)) {
      EXPECT_NEAR(row.kinetic, 1, static_cast<double>(row.events) * 48 * kUnit) << scene << row.dt_restitute;
    }
  }
}

/// A disturbance of the size of Δt_restitute is one like any other: the shorter, the later the runs part.
TEST_F(Grouping, OfTheTerminalPartsFromTheUngroupedRunLaterTheShorterItIs) {
  const std::vector<GroupingRow> rows = rows_of("terminal");
  const auto horizon_at = [&](double dt) {
    const auto found = std::find_if(rows.begin(), rows.end(),
                                    [&](const GroupingRow& row) { return row.dt_restitute == dt; });
    return found->horizon ? *found->horizon : found->collisions;
  };
  EXPECT_LT(horizon_at(1e-1), horizon_at(1e-4));
  EXPECT_LT(horizon_at(1e-4), horizon_at(1e-6));
  EXPECT_LT(horizon_at(1e-6), horizon_at(1e-8));
  EXPECT_LT(horizon_at(1e-8), horizon_at(1e-12));
  EXPECT_FALSE(std::find_if(rows.begin(), rows.end(), [](const GroupingRow& row) {
                 return row.dt_restitute == 1e-16;
               })->horizon);
}

/// 180°/θ events a turn; shares lost are 1 − c² of the energy and 1 − c of the angular momentum a turn, and
/// 1 − c^(θ/π) cos θ of the angular momentum at the first.
TEST(Revolution, TakesWhatEquation5Says) {
  ModelLevel level;
  measure_revolution(level, {});
  ASSERT_GE(level.revolution.size(), 30U);
  for (const RevolutionRow& row : level.revolution) {
    const double theta = row.theta_deg * std::numbers::pi / 180;
    const double cosine =
        row.theta_deg > 45 ? std::sin((90 - row.theta_deg) * std::numbers::pi / 180) : std::cos(theta);
    // An event rounds a velocity some 32 times, and a position, which a bend of 2θ is read from, 8 times; the
    // angular momentum is cos θ of |r||v|. What rounding adds to an event counts events_a_turn times.
    const double rounding = 32 * kUnit * (row.events_a_turn + 1 / cosine);
    EXPECT_NEAR(row.events_a_turn / (180 / row.theta_deg), 1, 8 * kUnit / theta + 32 * kUnit)
        << row.theta_deg;
    EXPECT_NEAR(row.energy_a_turn, 1 - row.c_revolve * row.c_revolve, 2 * rounding) << row.theta_deg;
    EXPECT_NEAR(row.momentum_a_turn, 1 - row.c_revolve, rounding) << row.theta_deg;
    const double first = std::pow(row.c_revolve, row.theta_deg / 180) * cosine;
    EXPECT_NEAR(row.momentum_at_first, 1 - first, 32 * kUnit) << row.theta_deg;
  }
}

}  // namespace
}  // namespace tps::cost
