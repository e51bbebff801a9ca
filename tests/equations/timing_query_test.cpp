#include "reference/equations/timing_query.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tps::test {

const TimingQuery kGood{TimingKind::block, {0, 0, 0}, {2, 0, 0}, {0, 0, 0}, {-1, 0, 0}, 1};

TEST(TimingQuery, IsValidWithFiniteNumbersAndAPositiveLimit) {
  EXPECT_TRUE(valid(kGood));
  for (const double L : {0.0, -1.0, HUGE_VAL, std::nan("")}) {
    TimingQuery bad = kGood;
    bad.L = L;
    EXPECT_FALSE(valid(bad)) << L;
  }
  for (std::array<double, 3> TimingQuery::*vector :
       {&TimingQuery::u_A, &TimingQuery::u_B, &TimingQuery::v_A, &TimingQuery::v_B}) {
    for (const double number : {HUGE_VAL, std::nan("")}) {
      for (std::size_t k = 0; k < 3; ++k) {
        TimingQuery bad = kGood;
        (bad.*vector)[k] = number;
        EXPECT_FALSE(valid(bad)) << number;
      }
    }
  }
}

TEST(TimingQuery, IsStaticWhereNoVelocityDiffers) {
  EXPECT_FALSE(is_static(kGood));
  TimingQuery query = kGood;
  query.v_A = query.v_B = {1, -2, 3};
  EXPECT_TRUE(is_static(query));
  query.v_B[2] = std::nextafter(3., 4.);
  EXPECT_FALSE(is_static(query));
  query.v_A = {0., 0., 0.};
  query.v_B = {-0., 0., -0.};
  EXPECT_TRUE(is_static(query));
}

}  // namespace tps::test
