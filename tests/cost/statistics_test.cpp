#include "verify/cost/statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tps::cost {
namespace {

TEST(Statistics, QuantilesInterpolateBetweenOrderStatistics) {
  const Quantiles q = quantiles({4, 1, 3, 2});
  EXPECT_EQ(q.min, 1);
  EXPECT_EQ(q.q1, 1.75);
  EXPECT_EQ(q.median, 2.5);
  EXPECT_EQ(q.q3, 3.25);
  EXPECT_EQ(q.max, 4);
  EXPECT_EQ(quantile({7}, 0.99), 7);
}

/// Closed forms: for k = 0 the upper end is 1 − (α/2)^(1/n), for k = n the lower one is (α/2)^(1/n).
TEST(Statistics, ClopperAndPearsonsEndsAreTheClosedForms) {
  for (const std::uint64_t n : {1U, 10U, 2000U, 1000000U}) {
    const double end = std::pow(0.025, 1.0 / static_cast<double>(n));
    EXPECT_EQ(proportion_interval(0, n, 0.95).low, 0);
    EXPECT_NEAR(proportion_interval(0, n, 0.95).high / (1 - end), 1, 1e-9) << n;
    EXPECT_NEAR(proportion_interval(n, n, 0.95).low / end, 1, 1e-9) << n;
    EXPECT_EQ(proportion_interval(n, n, 0.95).high, 1);
  }
}

/// 4 of 20 at 95 %: 0.0573 to 0.4366, as in tables of Clopper and Pearson's limits. By definition each end
/// leaves α/2.
TEST(Statistics, ClopperAndPearsonsEndsLeaveTheirTails) {
  const Interval interval = proportion_interval(4, 20, 0.95);
  EXPECT_NEAR(interval.low, 0.0573, 5e-5);
  EXPECT_NEAR(interval.high, 0.4366, 5e-5);
  const auto at_most_four = [](double p) {
    double sum = 0;
    for (int k = 0; k <= 4; ++k) {
      sum += std::exp(std::lgamma(21.0) - std::lgamma(k + 1.0) - std::lgamma(21.0 - k)) * std::pow(p, k) *
             std::pow(1 - p, 20 - k);
    }
    return sum;
  };
  EXPECT_NEAR(at_most_four(interval.high), 0.025, 1e-9);
}

TEST(Statistics, ARatioOfProportionalSamplesIsCertain) {
  std::vector<double> x, y;
  for (int i = 1; i <= 9; ++i) {
    y.push_back(i * i);
    x.push_back(3.0 * i * i);
  }
  const Interval interval = ratio_interval(x, y, 0.95, 1);
  EXPECT_EQ(interval.low, 3);
  EXPECT_EQ(interval.high, 3);
}

TEST(Statistics, ARatioOfScatteredSamplesIsNot) {
  const Interval interval = ratio_interval({1, 2, 3, 4, 5, 6, 7, 8, 9}, {5, 5, 5, 5, 5, 5, 5, 5, 5}, 0.95, 1);
  EXPECT_LT(interval.low, 1);
  EXPECT_GT(interval.high, 1);
  EXPECT_GE(interval.low, 0.2);
  EXPECT_LE(interval.high, 1.8);
}

}  // namespace
}  // namespace tps::cost
