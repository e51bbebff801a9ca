#include "reference/equations/eq3_apply_impulse.hpp"

#include "tests/equations/every_scalar.hpp"

namespace tps::test {

template <typename Scalar>
class Eq3 : public testing::Test {};
TYPED_TEST_SUITE(Eq3, EveryScalar, ScalarName);

TYPED_TEST(Eq3, ImpulseOverMassPlusOnAMinusOnB) {
  using S = TypeParam;
  const PairVelocities<S, 2> after =
      apply_impulse<S, 2>(S(2), S(4), vec<S>(1, 0), vec<S>(0, 1), vec<S>(4, -8));
  EXPECT_EQ(after.v_A, (vec<S>(3, -4)));
  EXPECT_EQ(after.v_B, (vec<S>(-1, 3)));
}

TYPED_TEST(Eq3, ConservesMomentumExactlyWhereNothingRounds) {
  using S = TypeParam;
  const PairVelocities<S, 3> after =
      apply_impulse<S, 3>(S(2), S(8), vec<S>(1, 2, 3), vec<S>(4, 5, 6), vec<S>(16, -24, 8));
  EXPECT_EQ((S(2) * after.v_A + S(8) * after.v_B).eval(), (vec<S>(34, 44, 54)));
}

TYPED_TEST(Eq3, AnInfiniteMassKeepsItsVelocity) {
  using S = TypeParam;
  const PairVelocities<S, 2> after =
      apply_impulse<S, 2>(infinity<S>(), S(0.5), vec<S>(1, 0), vec<S>(0, 1), vec<S>(3, 4));
  EXPECT_EQ(after.v_A, (vec<S>(1, 0)));
  EXPECT_EQ(after.v_B, (vec<S>(-6, -7)));
}

TYPED_TEST(Eq3, NoImpulseNoChange) {
  using S = TypeParam;
  const PairVelocities<S, 2> after =
      apply_impulse<S, 2>(S(3), S(7), vec<S>(0.1, 2), vec<S>(5, 0.3), vec<S>(0, 0));
  EXPECT_EQ(after.v_A, (vec<S>(0.1, 2)));
  EXPECT_EQ(after.v_B, (vec<S>(5, 0.3)));
}

}  // namespace tps::test
