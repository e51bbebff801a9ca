#include "reference/equations/eq2_approach.hpp"

#include "tests/equations/every_scalar.hpp"

namespace tps::test {

template <typename Scalar>
class Eq2Approach : public testing::Test {};
TYPED_TEST_SUITE(Eq2Approach, EveryScalar, ScalarName);

TYPED_TEST(Eq2Approach, BothFormsOfTheDiscriminantAgreeWhereNothingRounds) {
  using S = TypeParam;
  const Approach<S> far = approach<S, 2>(vec<S>(-4, 3), vec<S>(1, 0), S(2));  // h² = 16 ≥ a L² = 4
  EXPECT_EQ(far.a, S(1));
  EXPECT_EQ(far.h, S(-4));
  EXPECT_EQ(far.c, S(21));
  EXPECT_EQ(far.D, S(-5));
  const Approach<S> near = approach<S, 2>(vec<S>(-4, 3), vec<S>(1, 0), S(5));  // h² = 16 < a L² = 25
  EXPECT_EQ(near.c, S(0));
  EXPECT_EQ(near.D, S(16));
}

TYPED_TEST(Eq2Approach, LagrangeInThreeDimensions) {
  using S = TypeParam;
  const Vector<S, 3> r = vec<S>(2, -3, 7), v = vec<S>(5, 1, -2);
  EXPECT_EQ(cross_squared<S>(r, v), r.squaredNorm() * v.squaredNorm() - r.dot(v) * r.dot(v));
}

// One unit in the last place outside the limit, along an axis as in a line of particles: |r| and |r| − L are
// exact, r·r is not.
TEST(Eq2ApproachDouble, OnAnAxisTheDistanceToTheLimitIsExact) {
  const double r = std::nextafter(0.1, 1);
  const double c = approach<double, 2>(Vector<double, 2>(r, 0), Vector<double, 2>(-1, 0), 0.1).c;
  EXPECT_DOUBLE_EQ(c, (r - 0.1) * (r + 0.1));
  const double literal = r * r - 0.1 * 0.1;
  EXPECT_GT(std::abs(literal / c - 1), 0.1);  // r·r − L² has lost it
}

TYPED_TEST(Eq2Approach, ComfortableQueriesAreLeftAlone) {
  using S = TypeParam;
  const ScaledQuery<S, 2> q = scaled_query<S, 2>(vec<S>(3, 4), vec<S>(1, 2), S(1));
  EXPECT_EQ(q.time_exponent, 0);
  EXPECT_EQ(q.r, (vec<S>(3, 4)));
}

TEST(Eq2ApproachDouble, ScalingUndoesItself) {
  const ScaledQuery<double, 2> q =
      scaled_query<double, 2>(Vector<double, 2>(3e200, 4), Vector<double, 2>(1e-200, 2e-200), 1e200);
  EXPECT_EQ(std::ldexp(q.r[0] / q.v[0], q.time_exponent), HUGE_VAL);  // 3e400
  EXPECT_EQ(std::ldexp(q.r[0] / q.v[0], q.time_exponent - 1000), 3e200 / std::ldexp(1e-200, 1000));
  EXPECT_LT(q.r[0], 1);
  EXPECT_GE(q.r[0], 0.5);
}

}  // namespace tps::test
