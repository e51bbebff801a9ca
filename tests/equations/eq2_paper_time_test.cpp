#include "reference/equations/eq2_paper_time.hpp"

#include "reference/equations/eq2_collision_time.hpp"
#include "tests/equations/every_scalar.hpp"

namespace tps::test {

template <typename Scalar>
class Eq2Paper : public testing::Test {};
TYPED_TEST_SUITE(Eq2Paper, EveryScalar, ScalarName);

TYPED_TEST(Eq2Paper, RootsOfAHeadOnApproach) {
  using S = TypeParam;
  const PaperRoots<S> q = paper_roots<S, 2>(vec<S>(0, 0), vec<S>(5, 0), vec<S>(1, 0), vec<S>(0, 0), S(1));
  EXPECT_EQ(q.a, S(1));
  EXPECT_EQ(q.b, S(-10));
  EXPECT_EQ(q.c, S(24));
  EXPECT_EQ(q.discriminant, S(4));
  EXPECT_EQ(*q.minus, S(4));
  EXPECT_EQ(*q.plus, S(6));
}

TYPED_TEST(Eq2Paper, AgreesWithTheRuleByApproachWhereThePaperMeansIt) {
  using S = TypeParam;
  const Vector<S, 2> zero = vec<S>(0, 0);
  EXPECT_EQ(*(paper_time<S, 2>(zero, vec<S>(-10, 3), zero, vec<S>(1, 0), S(5))), S(6));
  EXPECT_FALSE((paper_time<S, 2>(zero, vec<S>(-3, 2), zero, vec<S>(1, 0), S(1))));  // not real
  EXPECT_FALSE((paper_time<S, 2>(zero, vec<S>(3, 0), zero, vec<S>(1, 0), S(1))));   // both negative
  EXPECT_FALSE((paper_time<S, 2>(zero, vec<S>(3, 0), zero, vec<S>(0, 0), S(1))));   // not finite
  EXPECT_EQ(*(paper_time<S, 2>(zero, vec<S>(3, 0), zero, vec<S>(1, 0), S(5))), S(2));
}

TYPED_TEST(Eq2Paper, AnswersZeroForAPairThatHasJustRebounded) {
  using S = TypeParam;
  const Vector<S, 2> zero = vec<S>(0, 0), r = vec<S>(1, 0), v = vec<S>(1, 0);
  const PaperRoots<S> q = paper_roots<S, 2>(zero, r, zero, v, S(1));
  EXPECT_EQ(*q.minus, S(-2));
  EXPECT_EQ(*q.plus, S(0));
  EXPECT_EQ(*(paper_time<S, 2>(zero, r, zero, v, S(1))), S(0));
  EXPECT_EQ((block_time<S, 2>(zero, r, zero, v, S(1)).verdict), TimingVerdict::receding);
}

TYPED_TEST(Eq2Paper, AnswersZeroForATetherThatHasJustBeenPulled) {
  using S = TypeParam;
  const Vector<S, 2> zero = vec<S>(0, 0), r = vec<S>(2, 0), v = vec<S>(-1, 0);
  EXPECT_EQ(*(paper_time<S, 2>(zero, r, zero, v, S(2))), S(0));
  EXPECT_EQ(*(tether_time<S, 2>(zero, r, zero, v, S(2)).t), S(4));
}

TYPED_TEST(Eq2Paper, EntersATetherFromOutsideInsteadOfLeavingIt) {
  using S = TypeParam;
  const Vector<S, 2> zero = vec<S>(0, 0), r = vec<S>(-10, 3), v = vec<S>(1, 0);
  EXPECT_EQ(*(paper_time<S, 2>(zero, r, zero, v, S(5))), S(6));  // approaching there
  EXPECT_EQ(*(tether_time<S, 2>(zero, r, zero, v, S(5)).t), S(14));
}

TEST(Eq2PaperDouble, TheLiteralDiscriminantLosesGrazes) {
  for (const double gap : {std::ldexp(1.0, -30), -std::ldexp(1.0, -30)}) {
    const PaperRoots<double> q = paper_roots<double, 2>({0, 0}, {-1e4, 1 - gap}, {0, 0}, {1, 0}, 1.0);
    EXPECT_EQ(q.discriminant, 0.0) << gap;  // exactly ±7.45e−9: a hit and a miss
  }
  const PaperRoots<double> oblique =
      paper_roots<double, 2>({0, 0}, {-3e7, 4e7 + .75}, {0, 0}, {.6, -.8}, 1.0);
  EXPECT_EQ(oblique.discriminant / 4, 1.0);  // exactly .7975
}

TEST(Eq2PaperDouble, TheTextbookRootCancels) {
  const std::optional<double> t =
      paper_time<double, 2>({0, 0}, {1 + std::ldexp(1.0, -50), 0}, {0, 0}, {-.75, .4}, 1.0);
  ASSERT_TRUE(t);
  EXPECT_NEAR(*t / 1.18423789293350046e-15 - 1, 0.038, 0.001);
}

// What --timing paper gets wrong: a graze that it takes for a touch, the time of a near contact, a tether's.
TEST(Eq2PaperDouble, SelectedByApproachItKeepsTheErrorsOfThePrintedFormulas) {
  using Vec = Vector<double, 2>;
  const Vec zero(0, 0);
  const Vec graze(-1e4, 1 - 0x1p-30);
  EXPECT_EQ((block_time<double, 2>(zero, graze, zero, Vec(1, 0), 1.).verdict), TimingVerdict::hit);
  EXPECT_EQ((paper_block_time<double, 2>(zero, graze, zero, Vec(1, 0), 1.).verdict), TimingVerdict::tangent);
  const Vec near(1 + 0x1p-50, 0);
  constexpr double exact = 1.18423789293350046e-15;  // by symmetry for both limits
  const std::optional<double> printed =
      paper_block_time<double, 2>(zero, Vec(1 + 0x1p-50, 0), zero, Vec(-.75, .4), 1.).t;
  ASSERT_TRUE(printed);
  EXPECT_NEAR(*printed / exact - 1, .038, .001);
  const Vec inside(1 - 0x1p-50, 0);
  const std::optional<double> printed_outer =
      paper_tether_time<double, 2>(zero, inside, zero, Vec(.75, .4), 1.).t;
  const std::optional<double> stable_outer = tether_time<double, 2>(zero, inside, zero, Vec(.75, .4), 1.).t;
  ASSERT_TRUE(printed_outer && stable_outer);
  EXPECT_NEAR(*printed_outer / exact - 1, .038, .001);
  EXPECT_NEAR(*stable_outer / exact - 1, 0, 8 * 0x1p-53);  // seven roundings, and one of `exact`
}

TEST(Eq2PaperDouble, RootsThatOverflowAreNotFinite) {
  const PaperRoots<double> q = paper_roots<double, 2>({0, 0}, {1e100, 0}, {0, 0}, {-1e60, 0}, 1e100);
  EXPECT_EQ(q.discriminant, HUGE_VAL);
  EXPECT_FALSE(q.plus);
  EXPECT_FALSE(q.minus);
}

// Every row of the tables of semantics §1 in numbers that do not round: the printed formulas give the answers
// of the stable ones.
TYPED_TEST(Eq2Paper, SelectedByApproachIsTheStableAnswerWhereNothingRounds) {
  using S = TypeParam;
  const Vector<S, 2> zero = vec<S>(0, 0);
  int events = 0;
  for (const auto& r :
       {vec<S>(-10, 3), vec<S>(-6, 8), vec<S>(-5, 0), vec<S>(5, 0), vec<S>(-4, 3), vec<S>(-3, 4),
        vec<S>(-1, 0), vec<S>(1, 0), vec<S>(10, 3), vec<S>(0, 5), vec<S>(-9, 5)}) {
    for (const auto& v : {vec<S>(1, 0), vec<S>(2, 0), vec<S>(0, 0)}) {
      const auto paper = paper_block_time<S, 2>(zero, r, zero, v, S(5));
      const auto stable = block_time<S, 2>(zero, r, zero, v, S(5));
      EXPECT_EQ(paper.verdict, stable.verdict);
      EXPECT_EQ(paper.t, stable.t);
      const auto paper_tether = paper_tether_time<S, 2>(zero, r, zero, v, S(5));
      const auto stable_tether = tether_time<S, 2>(zero, r, zero, v, S(5));
      EXPECT_EQ(paper_tether.verdict, stable_tether.verdict);
      EXPECT_EQ(paper_tether.t, stable_tether.t);
      events += (paper.t ? 1 : 0) + (paper_tether.t ? 1 : 0);
    }
  }
  EXPECT_EQ(events, 32);
}

}  // namespace tps::test
