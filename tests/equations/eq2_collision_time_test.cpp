#include "reference/equations/eq2_collision_time.hpp"

#include <array>

#include "reference/equations/eq1_distance.hpp"
#include "tests/equations/every_scalar.hpp"

namespace tps::test {

template <typename Scalar>
class Eq2 : public testing::Test {
 protected:
  using Vec = Vector<Scalar, 2>;
  using Time = CollisionTime<Scalar>;

  /// Both queries for particle B at r with velocity v, A at rest in the origin.
  static Time block(const Vec& r, const Vec& v, double L) {
    return block_time<Scalar, 2>(Vec(Vec::Zero()), r, Vec(Vec::Zero()), v, Scalar(L));
  }
  static Time tether(const Vec& r, const Vec& v, double L) {
    return tether_time<Scalar, 2>(Vec(Vec::Zero()), r, Vec(Vec::Zero()), v, Scalar(L));
  }
  static testing::AssertionResult is(const Time& answer, TimingVerdict verdict, std::optional<double> t) {
    if (answer.verdict != verdict) return testing::AssertionFailure() << name(answer.verdict);
    if (answer.t.has_value() != t.has_value()) return testing::AssertionFailure() << "t present or absent";
    if (t && !(*answer.t == Scalar(*t))) return testing::AssertionFailure() << "t = " << *answer.t;
    return testing::AssertionSuccess();
  }
};
TYPED_TEST_SUITE(Eq2, EveryScalar, ScalarName);

// The rows of the two tables, in their order. Every number in them is exact in every scalar.
TYPED_TEST(Eq2, BlockingVerdicts) {
  using S = TypeParam;
  using V = TimingVerdict;
  EXPECT_TRUE(this->is(this->block(vec<S>(3, 4), vec<S>(0, 0), 1), V::static_pair, {}));
  EXPECT_TRUE(this->is(this->block(vec<S>(0.5, 0), vec<S>(0, 0), 1), V::static_pair, {}));
  EXPECT_TRUE(this->is(this->block(vec<S>(3, 4), vec<S>(1, 0), 1), V::receding, {}));
  EXPECT_TRUE(this->is(this->block(vec<S>(3, 0), vec<S>(0, 1), 1), V::receding, {}));    // h = 0
  EXPECT_TRUE(this->is(this->block(vec<S>(0.5, 0), vec<S>(1, 0), 1), V::receding, {}));  // from inside
  EXPECT_TRUE(this->is(this->block(vec<S>(1, 0), vec<S>(1, 0), 1), V::receding, {}));    // just rebounded
  EXPECT_TRUE(this->is(this->block(vec<S>(0.5, 0), vec<S>(-1, 0), 1), V::overlap, 0.0));
  EXPECT_TRUE(this->is(this->block(vec<S>(3, 4), vec<S>(-1, 0), 5), V::contact, 0.0));
  EXPECT_TRUE(this->is(this->block(vec<S>(-3, 2), vec<S>(1, 0), 1), V::miss, {}));
  EXPECT_TRUE(this->is(this->block(vec<S>(-3, 1), vec<S>(1, 0), 1), V::tangent, {}));
  EXPECT_TRUE(this->is(this->block(vec<S>(-3, 0), vec<S>(1, 0), 1), V::hit, 2.0));
  EXPECT_TRUE(this->is(this->block(vec<S>(-10, 3), vec<S>(1, 0), 5), V::hit, 6.0));
}

TYPED_TEST(Eq2, TetheringVerdicts) {
  using S = TypeParam;
  using V = TimingVerdict;
  EXPECT_TRUE(this->is(this->tether(vec<S>(3, 4), vec<S>(0, 0), 1), V::static_pair, {}));
  EXPECT_TRUE(this->is(this->tether(vec<S>(3, 0), vec<S>(-1, 0), 5), V::hit, 8.0));  // c < 0, h < 0
  EXPECT_TRUE(this->is(this->tether(vec<S>(3, 0), vec<S>(0, 1), 5), V::hit, 4.0));   // c < 0, h = 0
  EXPECT_TRUE(this->is(this->tether(vec<S>(3, 0), vec<S>(1, 0), 5), V::hit, 2.0));   // c < 0, h > 0
  EXPECT_TRUE(this->is(this->tether(vec<S>(3, 4), vec<S>(1, 0), 5), V::taut, 0.0));
  EXPECT_TRUE(this->is(this->tether(vec<S>(5, 0), vec<S>(0, 1), 5), V::taut, 0.0));  // perpendicular
  EXPECT_TRUE(this->is(this->tether(vec<S>(2, 0), vec<S>(-1, 0), 2), V::hit, 4.0));  // c = 0, h < 0
  EXPECT_TRUE(this->is(this->tether(vec<S>(6, 0), vec<S>(1, 0), 5), V::overstretched, 0.0));
  EXPECT_TRUE(this->is(this->tether(vec<S>(6, 0), vec<S>(0, 1), 5), V::overstretched, 0.0));  // h = 0
  EXPECT_TRUE(this->is(this->tether(vec<S>(-10, 3), vec<S>(1, 0), 5), V::hit, 14.0));         // c > 0, D > 0
  EXPECT_TRUE(this->is(this->tether(vec<S>(-7, 5), vec<S>(1, 0), 5), V::turning, 7.0));       // D = 0
  EXPECT_TRUE(this->is(this->tether(vec<S>(-7, 6), vec<S>(1, 0), 5), V::turning, 7.0));       // D < 0
}

TYPED_TEST(Eq2, ThreeDimensions) {
  using S = TypeParam;
  const Vector<S, 3> zero = vec<S>(0, 0, 0), r = vec<S>(2, -11, 2), v = vec<S>(0, 1, 0);
  const CollisionTime<S> at = block_time<S, 3>(zero, r, zero, v, S(3));  // Lagrange: 2² + 2² + 1² = 3²
  EXPECT_EQ(at.verdict, TimingVerdict::hit);
  EXPECT_EQ(*at.t, S(10));
  EXPECT_EQ(*(tether_time<S, 3>(zero, r, zero, v, S(3)).t), S(12));
}

TYPED_TEST(Eq2, SwapOfNamesChangesNothingBitwise) {
  using S = TypeParam;
  const Vector<S, 3> u_A = vec<S>(0.1, 0.2, 0.3), u_B = vec<S>(5.7, -0.3, 0.9);
  const Vector<S, 3> v_A = vec<S>(1.4, -0.07, 0.2), v_B = vec<S>(-0.6, 0.1, 0.03);
  for (const double L : {1.3, 7.7}) {
    EXPECT_EQ((block_time<S, 3>(u_A, u_B, v_A, v_B, S(L)).t), (block_time<S, 3>(u_B, u_A, v_B, v_A, S(L)).t));
    EXPECT_EQ((tether_time<S, 3>(u_A, u_B, v_A, v_B, S(L)).t),
              (tether_time<S, 3>(u_B, u_A, v_B, v_A, S(L)).t));
  }
}

// .1·.3 − .3·.1 is 0; contracted to a fused multiply-add it is 1.67e−18, and swap symmetry is gone.
TEST(Eq2Contraction, ProductsAreRoundedBeforeTheyAreSubtracted) {
  volatile double x = 0.1, y = 0.3;
  EXPECT_EQ((cross_squared<double>(Vector<double, 2>(x, y), Vector<double, 2>(x, y))), 0.0);
  EXPECT_NE(std::fma(x, y, -(y * x)), 0.0);
}

TYPED_TEST(Eq2, PowersOfTwoScaleTimesBitwise) {
  using S = TypeParam;
  using std::ldexp;
  const Vector<S, 2> zero = vec<S>(0, 0), r = vec<S>(-2.3, 0.7), v = vec<S>(1.1, -0.2);
  const S L = S(1.3);
  const S t = *block_time<S, 2>(zero, r, zero, v, L).t;
  const S t_tether = *tether_time<S, 2>(zero, r, zero, v, L).t;
  for (const int k : {-90, -20, 20, 90}) {  // ±90: beyond the squares of float
    const Vector<S, 2> r_k = shifted<S, 2>(r, k), v_k = shifted<S, 2>(v, k);
    EXPECT_EQ(*(block_time<S, 2>(zero, r_k, zero, v_k, ldexp(L, k)).t), t) << k;
    EXPECT_EQ(*(tether_time<S, 2>(zero, r_k, zero, v_k, ldexp(L, k)).t), t_tether) << k;
    EXPECT_EQ(*(block_time<S, 2>(zero, r, zero, v_k, L).t), ldexp(t, -k)) << k;
    EXPECT_EQ(*(block_time<S, 2>(zero, r_k, zero, v, ldexp(L, k)).t), ldexp(t, k)) << k;
  }
}

class Eq2Double : public testing::Test {
 protected:
  static CollisionTime<double> block(Vector<double, 2> r, Vector<double, 2> v, double L) {
    return block_time<double, 2>({0, 0}, r, {0, 0}, v, L);
  }
};

TEST_F(Eq2Double, SpeedsWhoseSquaresLeaveTheRange) {
  for (const double s : {1e155, 1e300, 1e-170, 1e-300}) {
    const CollisionTime<double> at = block({-3, 0}, {s, 0}, 1);
    EXPECT_EQ(at.verdict, TimingVerdict::hit) << s;
    EXPECT_DOUBLE_EQ(*at.t, 2 / s) << s;
    EXPECT_EQ(block({-3, 2}, {s, 0}, 1).verdict, TimingVerdict::miss) << s;
    EXPECT_EQ(block({-3, 1}, {s, 0}, 1).verdict, TimingVerdict::tangent) << s;
  }
}

TEST_F(Eq2Double, SubnormalSpeedsAndLengths) {
  constexpr double tiny = 5e-324;
  EXPECT_EQ(*block({-3 * tiny, 0}, {tiny, 0}, tiny).t, 2);
  EXPECT_EQ(*block({-3, 0}, {4 * tiny, 0}, 1).t, HUGE_VAL);  // 2/(4·2^-1074) is beyond the range
  EXPECT_EQ(*block({-3 * tiny, 0}, {1, 0}, tiny).t, 2 * tiny);
}

// Beside |r|², L² vanishes below 2^-1074, and no scaling brings both into range: the sign of D is that of
// √a L − |r × v| then.
TEST_F(Eq2Double, ALimitFarBelowTheDistanceIsHitHeadOn) {
  const std::array<int, 6> exponents = {-1022, -600, -512, 0, 600, 1000};
  for (const int of_r : exponents) {
    for (const int of_L : exponents) {
      if (of_L > of_r) continue;
      const double r = std::ldexp(3.0, of_r);
      const double L = std::ldexp(1.0, of_L);
      for (const double v : {1.0, 0x1p-900, 0x1p900}) {
        const CollisionTime<double> at = block({-r, 0}, {v, 0}, L);
        EXPECT_EQ(at.verdict, TimingVerdict::hit) << of_r << ' ' << of_L;
        EXPECT_EQ(*at.t, (r - L) / v) << of_r << ' ' << of_L << ' ' << v;
        if (of_L > of_r - 50) continue;
        EXPECT_EQ(block({-r, std::ldexp(r, -40)}, {v, 0}, L).verdict, TimingVerdict::miss)
            << of_r << ' ' << of_L;
        const double beside = of_L > -1000 ? L / 2 : 0;
        EXPECT_EQ(block({-r, beside}, {v, 0}, L).verdict, TimingVerdict::hit) << of_r << ' ' << of_L;
      }
    }
  }
  EXPECT_EQ((block_time<double, 3>({0, 0, 0}, {-1, 0, 0}, {0, 0, 0}, {1, 0, 0}, 1e-200).verdict),
            TimingVerdict::hit);
  EXPECT_EQ((block_time<double, 3>({0, 0, 0}, {-1, 1e-180, 1e-180}, {0, 0, 0}, {1, 0, 0}, 1e-200).verdict),
            TimingVerdict::miss);
}

TEST_F(Eq2Double, GrazesFromAfarAreToldFromMisses) {
  for (const double x : {1e4, 1e6, 1e9}) {
    const double gap = std::ldexp(1.0, -30);
    EXPECT_EQ(block({-x, 1 - gap}, {1, 0}, 1).verdict, TimingVerdict::hit) << x;
    EXPECT_EQ(block({-x, 1 + gap}, {1, 0}, 1).verdict, TimingVerdict::miss) << x;
    const double D = approach<double, 2>(Vector<double, 2>(-x, 1 - gap), Vector<double, 2>(1, 0), 1.0).D;
    EXPECT_NEAR(D, 1.8626e-9, 1e-13) << x;
  }
}

// The exact value is .797500001998…; forming the minor at the size of |r||v| = 5e7 costs the rest.
TEST_F(Eq2Double, DiscriminantOfAnObliqueApproachFromAfar) {
  const double D = approach<double, 2>(Vector<double, 2>(-3e7, 4e7 + .75), Vector<double, 2>(.6, -.8), 1.0).D;
  EXPECT_NEAR(D, 0.79750000067, 1e-11);
  EXPECT_NEAR(D, 0.797500001998, 2e-9);
}

TEST_F(Eq2Double, JustOutsideTheLimitNothingCancels) {
  const CollisionTime<double> at = block({1 + std::ldexp(1.0, -50), 0}, {-.75, .4}, 1);
  EXPECT_EQ(at.verdict, TimingVerdict::hit);
  EXPECT_NEAR(*at.t / 1.18423789293350046e-15, 1, 3e-16);
}

TEST_F(Eq2Double, ExactTieAndItsNeighbours) {
  const double t = *block({-10, 3}, {1, 0}, 5).t;
  EXPECT_EQ(*block({-11, 0}, {1, 0}, 5).t, t);
  EXPECT_GT(*block({-11 - std::ldexp(1.0, -40), 0}, {1, 0}, 5).t, t);
  EXPECT_LT(*block({-11 + std::ldexp(1.0, -40), 0}, {1, 0}, 5).t, t);
}

TEST(Eq2Verdict, NamesAreThoseOfTheTables) {
  EXPECT_EQ(name(TimingVerdict::static_pair), "static");
  EXPECT_EQ(name(TimingVerdict::overstretched), "overstretched");
  EXPECT_EQ(name(TimingVerdict::turning), "turning");
}

}  // namespace tps::test
