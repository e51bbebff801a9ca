#include "reference/equations/angle.hpp"

#include "tests/equations/every_scalar.hpp"

namespace tps::test {

template <typename Scalar>
class Angle : public testing::Test {};
TYPED_TEST_SUITE(Angle, EveryScalar, ScalarName);

TYPED_TEST(Angle, TangentsThatAreKnownInClosedForm) {
  using S = TypeParam;
  using std::sqrt;
  const S root3 = sqrt(S(3));
  EXPECT_EQ(tan_degrees<S>(S(45)), S(1));
  EXPECT_TRUE(near_by<S>(tan_degrees<S>(S(60)), root3, 6, root3));
  EXPECT_TRUE(near_by<S>(tan_degrees<S>(S(30)), S(1) / root3, 6, S(1)));
}

// θ_revolve may be as near to 90° as 10⁻⁶°; x = 2^-20 degrees is exact, so is 90 − x (in float for 2^-10).
TYPED_TEST(Angle, NearNinetyDegreesIsTheInverseOfNearZero) {
  using S = TypeParam;
  using std::ldexp;
  const S x = ldexp(S(1), std::numeric_limits<S>::digits < 53 ? -10 : -20);
  const S product = tan_degrees<S>(x) * tan_degrees<S>(S(90) - x);
  EXPECT_TRUE(near_by<S>(product, S(1), 3, S(1)));
}

// In float the largest angle that a scene may have rounds to 90, whose tangent is infinite: a run of such a
// pair had velocities that are no numbers.
TYPED_TEST(Angle, StaysBelowNinetyDegreesInEveryScalar) {
  using S = TypeParam;
  const S theta = angle_in_degrees<S>(89.999999);
  EXPECT_LT(theta, S(90));
  EXPECT_LT(S(90) - theta, S(2e-5));
  EXPECT_LT(tan_degrees<S>(theta), S(6e7));
  EXPECT_EQ(angle_in_degrees<S>(45), S(45));
}

TYPED_TEST(Angle, SmallAnglesAreTheirRadians) {
  using S = TypeParam;
  using std::ldexp;
  // tan x = x + x³/3: for x = 2^-200 degrees (2^-60 in float's range) the cube is below rounding.
  const S degrees = ldexp(S(1), std::numeric_limits<S>::digits < 53 ? -60 : -200);
  EXPECT_TRUE(near_by<S>(tan_degrees<S>(degrees) * S(180) / degrees, pi<S>(), 6, pi<S>()));
}

}  // namespace tps::test
