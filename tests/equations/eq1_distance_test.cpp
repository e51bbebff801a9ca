#include "reference/equations/eq1_distance.hpp"

#include "tests/equations/every_scalar.hpp"

namespace tps::test {

template <typename Scalar>
class Eq1 : public testing::Test {};
TYPED_TEST_SUITE(Eq1, EveryScalar, ScalarName);

TYPED_TEST(Eq1, PythagoreanFlights) {
  using S = TypeParam;
  EXPECT_EQ((distance_after<S, 2>(vec<S>(0, 0), vec<S>(5, 0), vec<S>(1, 0), vec<S>(0, 0), S(4))), S(1));
  EXPECT_EQ((distance_after<S, 2>(vec<S>(0, 0), vec<S>(0, 4), vec<S>(0, 0), vec<S>(1, 0), S(3))), S(5));
  EXPECT_EQ((distance_after<S, 3>(vec<S>(1, 2, 3), vec<S>(2, 4, 5), vec<S>(1, 1, 1), vec<S>(0, 0, 0), S(0))),
            S(3));
  EXPECT_EQ((distance_after<S, 2>(vec<S>(0, 0), vec<S>(5, 0), vec<S>(1, 0), vec<S>(0, 0), S(-2))), S(7));
}

TYPED_TEST(Eq1, SwapOfNamesChangesNothingBitwise) {
  using S = TypeParam;
  const Vector<S, 2> u_A = vec<S>(0.1, 0.2), u_B = vec<S>(1.7, -0.3), v_A = vec<S>(-0.4, 0.77),
                     v_B = vec<S>(2, 0.6);
  EXPECT_EQ((distance_after<S, 2>(u_A, u_B, v_A, v_B, S(0.3))),
            (distance_after<S, 2>(u_B, u_A, v_B, v_A, S(0.3))));
}

TYPED_TEST(Eq1, EqualVelocitiesKeepTheDistance) {
  using S = TypeParam;
  EXPECT_EQ((distance_after<S, 2>(vec<S>(0, 0), vec<S>(3, 4), vec<S>(7, -2), vec<S>(7, -2), S(16))), S(5));
}

TEST(Eq1Range, SquaresBeyondTheRange) {
  EXPECT_EQ((distance_after<double, 2>({0, 0}, {0x3p+660, 0x4p+660}, {0, 0}, {0, 0}, 1.0)), 0x5p+660);
  EXPECT_EQ((distance_after<double, 2>({0, 0}, {0x3p-660, 0x4p-660}, {0, 0}, {0, 0}, 1.0)), 0x5p-660);
}

}  // namespace tps::test
