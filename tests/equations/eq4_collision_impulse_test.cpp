#include "reference/equations/eq4_collision_impulse.hpp"

#include "reference/equations/eq3_apply_impulse.hpp"
#include "tests/equations/every_scalar.hpp"

namespace tps::test {

template <typename Scalar>
class Eq4 : public testing::Test {};
TYPED_TEST_SUITE(Eq4, EveryScalar, ScalarName);

TYPED_TEST(Eq4, EqualMassesSwapTheirVelocitiesHeadOn) {
  using S = TypeParam;
  const Vector<S, 2> v_A = vec<S>(1, 0), v_B = vec<S>(-3, 0);
  const Vector<S, 2> dp = collision_impulse<S, 2>(vec<S>(0, 0), vec<S>(2, 0), v_A, v_B, S(1), S(1), S(1));
  EXPECT_EQ(dp, (vec<S>(-4, 0)));
  const PairVelocities<S, 2> after = apply_impulse<S, 2>(S(1), S(1), v_A, v_B, dp);
  EXPECT_EQ(after.v_A, v_B);
  EXPECT_EQ(after.v_B, v_A);
}

TYPED_TEST(Eq4, RestitutionIsTheRatioOfNormalSpeeds) {
  using S = TypeParam;
  const Vector<S, 2> u_A = vec<S>(0, 0), u_B = vec<S>(3, 4), v_A = vec<S>(2, 1), v_B = vec<S>(-1, 0.5);
  const S v_n = collision_frame<S, 2>(u_A, u_B, v_A, v_B).v_n;
  for (const double c : {0.0, 0.5, 0.9, 1.0}) {
    const Vector<S, 2> dp = collision_impulse<S, 2>(u_A, u_B, v_A, v_B, S(2), S(3), S(c));
    const PairVelocities<S, 2> after = apply_impulse<S, 2>(S(2), S(3), v_A, v_B, dp);
    const S v_n_after = collision_frame<S, 2>(u_A, u_B, after.v_A, after.v_B).v_n;
    EXPECT_TRUE(near_by<S>(v_n_after, -S(c) * v_n, 12, S(4))) << c;
  }
}

// The same number serves approaching and separating pairs: the sign of v_n is that of the impulse on A.
TYPED_TEST(Eq4, RetractionPullsWhereReboundPushes) {
  using S = TypeParam;
  EXPECT_EQ(
      (collision_impulse<S, 2>(vec<S>(0, 0), vec<S>(2, 0), vec<S>(0, 0), vec<S>(-4, 3), S(2), S(2), S(0.5))),
      (vec<S>(-6, 0)));
  EXPECT_EQ(
      (collision_impulse<S, 2>(vec<S>(0, 0), vec<S>(2, 0), vec<S>(0, 0), vec<S>(4, 3), S(2), S(2), S(0.5))),
      (vec<S>(6, 0)));
}

TYPED_TEST(Eq4, AWallReflects) {
  using S = TypeParam;
  const Vector<S, 2> v = vec<S>(-4, 3);
  const Vector<S, 2> dp =
      collision_impulse<S, 2>(vec<S>(0, 0), vec<S>(2, 0), vec<S>(0, 0), v, infinity<S>(), S(2), S(1));
  const PairVelocities<S, 2> after = apply_impulse<S, 2>(infinity<S>(), S(2), vec<S>(0, 0), v, dp);
  EXPECT_EQ(after.v_A, (vec<S>(0, 0)));
  EXPECT_EQ(after.v_B, (vec<S>(4, 3)));
}

// The first collision of the paper's chain X, Y, Z: m_Y a thousandth, elastic: v_Y = 2/(1 + m_Y).
TYPED_TEST(Eq4, ThousandToOneTransfersTwiceTheVelocity) {
  using S = TypeParam;
  const S m_Y = S(1) / S(1000);
  const Vector<S, 2> dp =
      collision_impulse<S, 2>(vec<S>(0, 0), vec<S>(1, 0), vec<S>(1, 0), vec<S>(0, 0), S(1), m_Y, S(1));
  const PairVelocities<S, 2> after = apply_impulse<S, 2>(S(1), m_Y, vec<S>(1, 0), vec<S>(0, 0), dp);
  EXPECT_TRUE(near_by<S>(after.v_B[0], S(2000) / S(1001), 8, S(2)));
  EXPECT_TRUE(near_by<S>(after.v_A[0], S(999) / S(1001), 8, S(1)));
}

TYPED_TEST(Eq4, SwapFlipsTheImpulseBitwise) {
  using S = TypeParam;
  const Vector<S, 3> u_A = vec<S>(0.1, 0.2, 0.3), u_B = vec<S>(1.7, -0.3, 0.9);
  const Vector<S, 3> v_A = vec<S>(-0.4, 0.77, 0.2), v_B = vec<S>(0.6, -1.1, 3.3);
  EXPECT_EQ((collision_impulse<S, 3>(u_A, u_B, v_A, v_B, S(2), S(3), S(0.7))),
            (-collision_impulse<S, 3>(u_B, u_A, v_B, v_A, S(3), S(2), S(0.7))).eval());
}

}  // namespace tps::test
