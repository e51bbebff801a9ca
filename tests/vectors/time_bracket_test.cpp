// Brackets of times where doubles end, and twins.
#include "verify/vectors/time_bracket.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "verify/vectors/one_bit.hpp"
#include "verify/vectors/timing_strata.hpp"

namespace tps::vectors {
namespace {

using exact::Kind;
using exact::Verdict;
using exact::strata::relative;

constexpr double max_double = std::numeric_limits<double>::max();
constexpr double min_double = std::numeric_limits<double>::denorm_min();

TEST(TimeBracket, OfAnIrrationalTimeAreAdjacentDoublesWithASignChange) {
  const TimingProof proof = prove(relative(Kind::block, {-7, 1, 0}, {1, 0, 0}, 3));  // 7 − √8
  ASSERT_TRUE(proof.bracket);
  const TimeBracket& b = *proof.bracket;
  EXPECT_EQ(b.hi, std::nextafter(b.lo, HUGE_VAL));
  EXPECT_EQ(b.sign_lo, 1);
  EXPECT_EQ(b.sign_hi, -1);
  EXPECT_NEAR(b.nearest, 7 - std::sqrt(8.0), 1e-15);
  EXPECT_EQ(proof.A, "0x1p+0");
  EXPECT_EQ(proof.B, "-0x7p+1");
  EXPECT_EQ(proof.C, "0x29p+0");
  EXPECT_EQ(proof.sign_D, 1);
}

TEST(TimeBracket, OfADoubleIsThatDouble) {
  const TimingProof proof = prove(relative(Kind::block, {-10, 3, 0}, {1, 0, 0}, 5));
  EXPECT_EQ(proof.bracket->lo, 6);
  EXPECT_EQ(proof.bracket->hi, 6);
  EXPECT_EQ(proof.bracket->sign_lo, 0);
}

TEST(TimeBracket, OfTurningTellsTheSideOfClosestApproach) {
  const TimingProof proof = prove(relative(Kind::tether, {-1, 5, 0}, {3, 0, 0}, 2));
  EXPECT_EQ(proof.verdict, Verdict::turning);
  EXPECT_EQ(proof.bracket->sign_lo, -1);
  EXPECT_EQ(proof.bracket->sign_hi, 1);
  EXPECT_EQ(proof.bracket->nearest, 1.0 / 3);
}

TEST(TimeBracket, ReachesBeyondTheLargestAndBelowTheSmallestDouble) {
  const TimeBracket late = *prove(relative(Kind::block, {2, 0, 0}, {-min_double, 0, 0}, 1)).bracket;
  EXPECT_EQ(late.lo, max_double);
  EXPECT_EQ(late.hi, HUGE_VAL);
  EXPECT_EQ(late.nearest, HUGE_VAL);
  const TimeBracket soon =
      *prove(relative(Kind::block, {2 * min_double, 0, 0}, {-4, 0, 0}, min_double)).bracket;
  EXPECT_EQ(soon.lo, 0);
  EXPECT_EQ(soon.hi, min_double);
  EXPECT_EQ(soon.nearest, 0);
}

TEST(TimeBracket, ConditionGrowsTowardsAGraze) {
  double last = 0;
  for (const int k : {5, 15, 25, 35, 45}) {
    const exact::TimingQuery query = exact::strata::graze(Kind::block, k, 1, 8, 0);
    const double cond = *condition(query, prove(query));
    EXPECT_GT(cond, 10 * last) << k;
    last = cond;
  }
}

// √D is 2^-85 of |h|, and the time 2/3 of the smallest double: neither a t + h nor the nearest double will
// do.
TEST(TimeBracket, ConditionIsThatOfTheExactTime) {
  const exact::TimingQuery graze = relative(Kind::tether, {-0x1p60, 1, 0}, {1, 0, 0}, 1 + 0x1p-52);
  const double expected = 0x1p61 / std::sqrt(0x1p-52 * (2 + 0x1p-52));
  EXPECT_NEAR(*condition(graze, prove(graze)), expected, 1e-12 * expected);
  const exact::TimingQuery soon =
      relative(Kind::tether, {-3 * min_double, 4 * min_double, 0}, {2, 1, -1}, 5 * min_double);
  EXPECT_NEAR(*condition(soon, prove(soon)), 24.75, 1e-12);
}

TEST(Twins, AreTheTwoDoublesAtTheEdge) {
  for (const double sign : {1.0, -1.0}) {
    const auto [near, far] = straddling_doubles(sign * 1.0, sign * 2.0, [](double x) { return x * x < 2; });
    EXPECT_LT(near * near, 2);
    EXPECT_GE(far * far, 2);
    EXPECT_EQ(far, std::nextafter(near, sign * 9));
  }
}

}  // namespace
}  // namespace tps::vectors
