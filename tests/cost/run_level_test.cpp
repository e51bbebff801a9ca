#include "verify/cost/run_level.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tps::cost {
namespace {

RunRow stable_row(int bits, std::uint64_t horizon) {
  RunRow row;
  row.scene = "line";
  row.timing = "stable";
  row.bits = bits;
  row.horizon = horizon;
  return row;
}

TEST(Horizons, OnAStraightLineAreFittedExactly) {
  const HorizonFit fit =
      fit_horizons("line", {stable_row(24, 58), stable_row(53, 116), stable_row(113, 236)});
  EXPECT_EQ(fit.points, 3);
  EXPECT_NEAR(fit.events_per_bit, 2, 1e-12);
  EXPECT_NEAR(fit.standard_error, 0, 1e-12);
  EXPECT_NEAR(fit.exponent(), std::log(2.0) / 2, 1e-12);
  EXPECT_NEAR(fit.exponent_error(), 0, 1e-12);
}

/// In 300 events twenty spheres leave the run of 100 digits in float, and in nothing wider; X-Y-Z never does.
TEST(Horizons, OfAShortRunSeparateFloatFromTheRest) {
  RunLevelOptions options;
  options.events = 300;
  options.proves_stored = false;
  const RunLevel level = measure_runs(options);
  EXPECT_EQ(level.rows.size(), 28U) << "two scenes, six scalars, paper and stable, certified for two";
  for (const RunRow& row : level.rows) {
    EXPECT_EQ(row.events, row.scene == "gas" ? 300U : 70U) << row.scalar;
    EXPECT_EQ(row.horizon.has_value(), row.scene == "gas" && row.scalar == "float")
        << row.scalar << " " << row.timing;
    EXPECT_GT(row.events_per_second, 0);
  }
  ASSERT_EQ(level.proven.size(), 2U);
  for (const ProvenRow& row : level.proven) {
    EXPECT_EQ(row.events, row.scene == "gas" ? 300U : 70U) << "every start has them";
    EXPECT_FALSE(row.parts_at) << "the run in 100 digits has others";
  }
  EXPECT_TRUE(level.fits.empty()) << "one horizon makes no line";
}

}  // namespace
}  // namespace tps::cost
