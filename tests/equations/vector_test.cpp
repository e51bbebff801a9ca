#include "reference/equations/vector.hpp"

#include "tests/equations/every_scalar.hpp"

namespace tps::test {

template <typename Scalar>
class VectorLength : public testing::Test {};
TYPED_TEST_SUITE(VectorLength, EveryScalar, ScalarName);

TYPED_TEST(VectorLength, PaperExampleTwoThreeFour) {
  using S = TypeParam;
  using std::sqrt;
  const Vector<S, 3> x = vec<S>(2, 3, 4);
  EXPECT_EQ(x.cwiseProduct(x).eval(), (vec<S>(4, 9, 16)));
  EXPECT_EQ(x.squaredNorm(), S(29));
  EXPECT_EQ((norm<S, 3>(x)), sqrt(S(29)));
}

TYPED_TEST(VectorLength, ScalesByPowersOfTwoBitwise) {
  using S = TypeParam;
  using std::ldexp;
  const Vector<S, 2> x = vec<S>(0.3, -1.7);
  for (const int k : {-100, -7, 7, 100}) {
    EXPECT_EQ((norm<S, 2>(shifted<S, 2>(x, k))), ldexp(norm<S, 2>(x), k)) << k;
    EXPECT_EQ((unit_vector<S, 2>(shifted<S, 2>(x, k))), (unit_vector<S, 2>(x))) << k;
  }
}

// Squares of these over- or underflow in double and in the archetype.
TEST(VectorRange, HugeTinyAndSubnormalVectorsHaveLengthAndDirection) {
  for (const double s : {0x1p+660, 0x1p-660, 0x1p-1070}) {
    const Vector<double, 2> x(3 * s, -4 * s);
    EXPECT_EQ((norm<double, 2>(x)), 5 * s);
    EXPECT_EQ((unit_vector<double, 2>(x)), (Vector<double, 2>(3, -4) / 5.0)) << s;
  }
  EXPECT_EQ((norm<double, 2>(Vector<double, 2>(0, 0))), 0);
}

}  // namespace tps::test
