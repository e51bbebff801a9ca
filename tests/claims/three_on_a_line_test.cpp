// The analysis of X-Y-Z against its collisions carried out one by one in 300 digits.
#include "verify/claims/three_on_a_line.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tps::claims {
namespace {

TEST(ThreeOnALine, FormulaCountsWhatHappensOneByOne) {
  for (const double mass : {1.0, 0.1, 0.01, 0.001, 1e-4}) {
    for (const double above : {1e-4, 1e-3, 1e-2, 0.1, 1.0}) {
      const double e_c = collapse_restitution(mass);
      const double e = e_c + (1 - e_c) * above;
      const Counted counted = count_one_by_one(mass, e);
      EXPECT_EQ(collisions_by_formula(mass, e), counted.collisions) << "m_Y = " << mass << ", c = " << e;
      EXPECT_NEAR(last_approach_by_formula(mass, e), counted.log10_smallest_approach, 1e-9)
          << "m_Y = " << mass << ", c = " << e;
    }
  }
}

TEST(ThreeOnALine, EqualMassesCollapseAtTheLiteratureValue) {
  // 7 − 4√3 (McNamara and Young 1992).
  EXPECT_NEAR(collapse_restitution(1), 7 - 4 * std::sqrt(3.0), 1e-15);
}

TEST(ThreeOnALine, ThresholdsMoveToTheBoundWithPrecision) {
  const double e_c = collapse_restitution(0.001);
  double before = 1;
  for (const int digits : {16, 34, 50, 100, 1000}) {
    const double now = restitution_where_speeds_reach(0.001, -digits);
    EXPECT_LT(now, before);
    EXPECT_GT(now, e_c);
    before = now;
  }
}

}  // namespace
}  // namespace tps::claims
