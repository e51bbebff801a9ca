#include "reference/equations/eq6_load_velocity.hpp"

#include "tests/equations/every_scalar.hpp"

namespace tps::test {

template <typename Scalar>
class Eq6 : public testing::Test {};
TYPED_TEST_SUITE(Eq6, EveryScalar, ScalarName);

TYPED_TEST(Eq6, IsTheVelocityOfTheCentreOfMass) {
  using S = TypeParam;
  EXPECT_EQ((load_velocity<S, 2>(S(1), S(1), vec<S>(1, 0), vec<S>(0, 3))), (vec<S>(0.5, 1.5)));
  EXPECT_EQ((load_velocity<S, 2>(S(1), S(3), vec<S>(4, 8), vec<S>(0, 0))), (vec<S>(1, 2)));
  EXPECT_TRUE((near_by<S, 3>(load_velocity<S, 3>(S(2), S(1), vec<S>(3, 0, 6), vec<S>(0, 3, 0)),
                             vec<S>(2, 1, 4), 6, S(4))));
}

// The paper's chain: X (1) loads Y (1/1000), then X+Y loads Z (1): v = 1000/1001, then 1000/2001.
TYPED_TEST(Eq6, LoadsTheChainOfThePaper) {
  using S = TypeParam;
  const S m_Y = S(1) / S(1000);
  const Vector<S, 2> v_XY = load_velocity<S, 2>(S(1), m_Y, vec<S>(1, 0), vec<S>(0, 0));
  EXPECT_TRUE(near_by<S>(v_XY[0], S(1000) / S(1001), 4, S(1)));
  const Vector<S, 2> v_XYZ = load_velocity<S, 2>(S(1) + m_Y, S(1), v_XY, vec<S>(0, 0));
  EXPECT_TRUE(near_by<S>(v_XYZ[0], S(1000) / S(2001), 8, S(0.5)));
}

TYPED_TEST(Eq6, AnInfiniteMassSetsTheVelocity) {
  using S = TypeParam;
  EXPECT_EQ((load_velocity<S, 2>(infinity<S>(), S(2), vec<S>(0.1, 7), vec<S>(5, 5))), (vec<S>(0.1, 7)));
  EXPECT_EQ((load_velocity<S, 2>(S(2), infinity<S>(), vec<S>(5, 5), vec<S>(0.1, 7))), (vec<S>(0.1, 7)));
}

TYPED_TEST(Eq6, SwapOfNamesChangesNothingBitwise) {
  using S = TypeParam;
  const Vector<S, 2> v_A = vec<S>(0.1, 7), v_B = vec<S>(-0.3, 0.9);
  EXPECT_EQ((load_velocity<S, 2>(S(3), S(0.7), v_A, v_B)), (load_velocity<S, 2>(S(0.7), S(3), v_B, v_A)));
}

TEST(Eq6Range, ARatioThatOverflowsIsAnInfiniteMass) {
  EXPECT_EQ((load_velocity<double, 2>(1e300, 1e-300, {1, 2}, {3, 4})), (Vector<double, 2>(1, 2)));
}

}  // namespace tps::test
