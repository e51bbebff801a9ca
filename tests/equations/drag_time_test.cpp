// The time of a clock under drag: its ends, and that it is the inverse of s(t).
#include "reference/equations/drag_time.hpp"

#include "tests/equations/every_scalar.hpp"

namespace tps::test {
namespace {

template <typename Scalar>
class DragTime : public testing::Test {};
TYPED_TEST_SUITE(DragTime, EveryScalar, ScalarName);

TYPED_TEST(DragTime, BeginsAtZeroAndEnds) {
  using S = TypeParam;
  EXPECT_EQ(*drag_time<S>(S(2), S(0)), S(0));
  EXPECT_FALSE(drag_time<S>(S(2), S(0.5)));
  EXPECT_FALSE(drag_time<S>(S(2), S(7)));
  EXPECT_TRUE(drag_time<S>(S(2), S(0.5) - roundoff<S>()));
}

// Half of the way to the end takes ln 2, and each further half as long again.
TYPED_TEST(DragTime, HalvesTakeEquallyLong) {
  using S = TypeParam;
  const S one = *drag_time<S>(S(1), S(0.5)), two = *drag_time<S>(S(1), S(0.75));
  using std::abs;
  EXPECT_LE(S(abs(S(two - S(2) * one))), S(8) * roundoff<S>() * two);
}

// Laws (2) and (3).
TYPED_TEST(DragTime, RisesAndScales) {
  using S = TypeParam;
  S last(0);
  for (int k = 1; k < 16; ++k) {
    const S s = S(k) / S(16);
    const S t = *drag_time<S>(S(1), s);
    EXPECT_GT(t, s);
    EXPECT_GT(t, last);
    EXPECT_EQ(*drag_time<S>(S(4), S(s / S(4))), S(t / S(4)));
    last = t;
  }
}

}  // namespace
}  // namespace tps::test
