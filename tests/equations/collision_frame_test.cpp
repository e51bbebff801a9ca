#include "reference/equations/collision_frame.hpp"

#include "tests/equations/every_scalar.hpp"

namespace tps::test {

template <typename Scalar>
class Frame : public testing::Test {};
TYPED_TEST_SUITE(Frame, EveryScalar, ScalarName);

TYPED_TEST(Frame, SplitsTheRelativeVelocityAlongAndAcross) {
  using S = TypeParam;
  const CollisionFrame<S, 2> f =
      collision_frame<S, 2>(vec<S>(1, 1), vec<S>(4, 5), vec<S>(1, 0), vec<S>(-9, 5));
  EXPECT_TRUE((near_by<S, 2>(f.u_hat, vec<S>(3, 4) / S(5), 1, S(1))));
  EXPECT_EQ(f.v_AB, (vec<S>(-10, 5)));
  // v_n = (−30 + 20) / 5; each operation is rounded at the size of v_AB.
  EXPECT_TRUE(near_by<S>(f.v_n, S(-2), 4, S(11)));
  EXPECT_TRUE((near_by<S, 2>(f.v_u, vec<S>(-6, -8) / S(5), 4, S(11))));
  EXPECT_TRUE((near_by<S, 2>(f.v_w, vec<S>(-44, 33) / S(5), 5, S(11))));
}

TYPED_TEST(Frame, SwapFlipsVectorsAndKeepsTheNormalVelocityBitwise) {
  using S = TypeParam;
  const Vector<S, 3> u_A = vec<S>(0.1, 0.2, 0.3), u_B = vec<S>(1.7, -0.3, 0.9);
  const Vector<S, 3> v_A = vec<S>(-0.4, 0.77, 0.2), v_B = vec<S>(0.6, -1.1, 3.3);
  const CollisionFrame<S, 3> f = collision_frame<S, 3>(u_A, u_B, v_A, v_B);
  const CollisionFrame<S, 3> g = collision_frame<S, 3>(u_B, u_A, v_B, v_A);
  EXPECT_EQ(g.v_n, f.v_n);
  EXPECT_EQ(g.u_hat, (-f.u_hat).eval());
  EXPECT_EQ(g.v_AB, (-f.v_AB).eval());
  EXPECT_EQ(g.v_u, (-f.v_u).eval());
  EXPECT_EQ(g.v_w, (-f.v_w).eval());
}

TYPED_TEST(Frame, ReducedMassOfFiniteAndInfiniteMasses) {
  using S = TypeParam;
  EXPECT_EQ(reduced_mass<S>(S(2), S(2)), S(1));
  EXPECT_TRUE(near_by<S>(reduced_mass<S>(S(3), S(6)), S(2), 4, S(2)));
  EXPECT_EQ(reduced_mass<S>(S(1), S(1000)), reduced_mass<S>(S(1000), S(1)));
  for (const int m : {1, 3, 49, 1000}) {
    EXPECT_TRUE(near_by<S>(reduced_mass<S>(infinity<S>(), S(m)), S(m), 2, S(m))) << m;
    EXPECT_EQ(reduced_mass<S>(S(m), infinity<S>()), reduced_mass<S>(infinity<S>(), S(m))) << m;
  }
}

TEST(FrameRange, ReducedMassOfAnInfiniteMassIsTheOtherOnlyToRounding) {
  EXPECT_NE(reduced_mass<double>(HUGE_VAL, 49.0), 49.0);  // 1/(1/49); the docstring says so
}

TEST(FrameRange, DistancesWhoseSquaresLeaveTheRange) {
  for (const double s : {0x1p-566, 0x1p+516, 0x1p-1074}) {
    const CollisionFrame<double, 2> f =
        collision_frame<double, 2>({0, 0}, {3 * s, 4 * s}, {0, 0}, {-1e160, 0});
    EXPECT_EQ(f.u_hat, (Vector<double, 2>(0.6, 0.8))) << s;
    EXPECT_DOUBLE_EQ(f.v_n, -0.6e160) << s;
  }
}

}  // namespace tps::test
