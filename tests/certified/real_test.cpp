// Rounding of exact and enclosed numbers to doubles.
#include "verify/certified/real.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>

#include "verify/certified/enclosure.hpp"

namespace tps::certified {
namespace {

constexpr double kLargest = std::numeric_limits<double>::max();
constexpr double kSmallest = std::numeric_limits<double>::denorm_min();

Real power_of_two(int exponent) {
  const Integer power = Integer(1) << static_cast<unsigned>(std::abs(exponent));
  return exponent >= 0 ? Rational(power) : Rational(Integer(1), power);
}

void expect_enclosure(const Real& x, double lo, double hi, double nearest) {
  for (const bool negative : {false, true}) {
    const Enclosure e = enclosure(negative ? Real(-1) * x : x);
    EXPECT_EQ(e.lo, negative ? -hi : lo);
    EXPECT_EQ(e.hi, negative ? -lo : hi);
    EXPECT_EQ(e.nearest, negative ? -nearest : nearest);
    EXPECT_TRUE(e.settled);
  }
}

TEST(Enclosure, OfADoubleIsThatDouble) {
  std::mt19937_64 bits(1);
  for (int n = 0; n < 2000; ++n) {
    const double x = std::bit_cast<double>(bits());
    if (std::isfinite(x)) expect_enclosure(Real::of(std::fabs(x)), std::fabs(x), std::fabs(x), std::fabs(x));
  }
  for (const double x : {0.0, kSmallest, 3 * kSmallest, 0x1p-1022, 0x1.fffffffffffffp-1023, kLargest, 1.0})
    expect_enclosure(Real::of(x), x, x, x);
}

TEST(Enclosure, RoundsToNearestEven) {
  const double above = std::nextafter(1.0, 2.0);
  const Real half_unit = power_of_two(-53);
  expect_enclosure(Real(1) + half_unit, 1, above, 1);
  expect_enclosure(Real::of(above) + half_unit, above, std::nextafter(above, 2), std::nextafter(above, 2));
  expect_enclosure(Real(1) + half_unit + power_of_two(-2000), 1, above, above);
  expect_enclosure(Real(1) + half_unit - power_of_two(-2000), 1, above, 1);
  expect_enclosure(Real(2) - power_of_two(-60), std::nextafter(2, 0), 2, 2);
}

TEST(Enclosure, OverflowsAndUnderflowsAsIeee754Rounds) {
  const Real end = power_of_two(1024);
  const Real threshold = end - power_of_two(970);
  expect_enclosure(threshold, kLargest, HUGE_VAL, HUGE_VAL);
  expect_enclosure(threshold - power_of_two(-900), kLargest, HUGE_VAL, kLargest);
  expect_enclosure(end, kLargest, HUGE_VAL, HUGE_VAL);
  expect_enclosure(end * end, kLargest, HUGE_VAL, HUGE_VAL);
  expect_enclosure(power_of_two(-1075), 0, kSmallest, 0);
  expect_enclosure(power_of_two(-1075) + power_of_two(-3000), 0, kSmallest, kSmallest);
  expect_enclosure(power_of_two(-5000), 0, kSmallest, 0);
  expect_enclosure(Real(3) * power_of_two(-1075), kSmallest, 2 * kSmallest, 2 * kSmallest);
}

TEST(Enclosure, OfAnIrrationalNumberHasAdjacentEnds) {
  const Enclosure root = enclosure(sqrt(Real(2)));
  EXPECT_EQ(root.hi, std::nextafter(root.lo, 2));
  EXPECT_EQ(root.nearest, std::sqrt(2.0));  // correctly rounded by IEEE 754
  EXPECT_TRUE(root.settled);
}

// 2 ∛½ / ∛½ is 2, but balls do not know it: 2 lies inside, its neighbours are the ends.
Real two_in_a_ball() {
  const Real cube_root = squared_speed_ratio(0.5, 30);
  return Real(2) * cube_root / cube_root;
}

TEST(Enclosure, ADoubleThatIsNotProvenLiesBetweenItsNeighbours) {
  const Enclosure two = enclosure(two_in_a_ball());
  EXPECT_EQ(two.lo, std::nextafter(2.0, 0));
  EXPECT_EQ(two.hi, std::nextafter(2.0, 3));
  EXPECT_EQ(two.nearest, 2);
  EXPECT_TRUE(two.settled);

  const Enclosure zero = enclosure(two_in_a_ball() - Real(2));
  EXPECT_LT(zero.lo, 0);
  EXPECT_GT(zero.hi, 0);
  EXPECT_LT(zero.hi - zero.lo, 1e-118);
  EXPECT_EQ(zero.nearest, 0);
  EXPECT_FALSE(zero.settled);

  const Enclosure middle = enclosure(two_in_a_ball() + power_of_two(-52));
  EXPECT_EQ(middle.nearest, 2);
  EXPECT_FALSE(middle.settled);
}

TEST(Enclosure, OneSquareRootIsDecidedExactly) {
  const Real root = sqrt(Real(2));
  expect_enclosure(root * root, 2, 2, 2);
  expect_enclosure(root * root - Real(2), 0, 0, 0);
  expect_enclosure(Real(Rational(1, 2)) * root * sqrt(Real(8)) + power_of_two(-52), 2, std::nextafter(2.0, 3),
                   2);
  expect_enclosure(sqrt(Real(3) + Real(2) * root) - root, 1, 1, 1);
  expect_enclosure(Real(1) / (root - Real(1)) - root, 1, 1, 1);
}

/// Numbers that differ by far less than the first precision shows from the middle of two doubles.
TEST(Enclosure, MoreBitsSettleWhatFewDoNot) {
  int escalated = 0;
  const Real middle = Real(1) + power_of_two(-53);
  for (int exponent = 600; exponent <= 15000; exponent += 600) {
    const Real tiny = power_of_two(-exponent);
    const auto sum = [&](int sign) { return enclosure(Real(middle.ball()) + Real(sign) * tiny); };
    const Enclosure above = settled([&] { return sum(1); });
    const Enclosure below = settled([&] { return sum(-1); });
    EXPECT_TRUE(above.settled && below.settled) << exponent;
    EXPECT_EQ(above.nearest, std::nextafter(1.0, 2)) << exponent;
    EXPECT_EQ(below.nearest, 1) << exponent;
    escalated += sum(1).settled ? 0 : 1;
  }
  EXPECT_EQ(escalated, 25) << "cases that the first precision leaves open";
}

TEST(Real, RootsOfSquaresAreExact) {
  ASSERT_NE(sqrt(Real(Rational(9, 16))).rational(), nullptr);
  EXPECT_EQ(*sqrt(Real(Rational(9, 16))).rational(), Rational(3, 4));
  EXPECT_EQ(sqrt(Real(Rational(9, 17))).rational(), nullptr);
  EXPECT_NE(sqrt(Real(Rational(9, 17))).surd(), nullptr);
}

TEST(Real, ExactAnglesAreThoseOfNiven) {
  EXPECT_EQ(*cos_squared_degrees(30).rational(), Rational(3, 4));
  EXPECT_EQ(*cos_squared_degrees(45).rational(), Rational(1, 2));
  EXPECT_EQ(*cos_squared_degrees(60).rational(), Rational(1, 4));
  EXPECT_EQ(cos_squared_degrees(59).rational(), nullptr);
  // cos² 72° = ((√5 − 1)/4)²
  const Real golden = (sqrt(Real(5)) - Real(1)) / Real(4);
  EXPECT_EQ(sign(cos_squared_degrees(72) - golden * golden), Sign::zero);
  for (const double theta : {15.0, 18.0, 22.5, 30.0, 36.0, 45.0, 54.0, 60.0, 67.5, 72.0, 75.0}) {
    const Real near = cos_squared_degrees(theta), beside = cos_squared_degrees(std::nextafter(theta, 0));
    EXPECT_TRUE(beside.surd() == nullptr && beside.rational() == nullptr);
    EXPECT_EQ(sign(beside - near), Sign::positive) << theta;
    EXPECT_EQ(sign(beside - near - power_of_two(-50)), Sign::negative) << theta;
  }
  EXPECT_EQ(sign(cos_squared_degrees(std::nextafter(72.0, 73.0)) - golden * golden), Sign::negative);
}

TEST(Real, SpeedRatioOfAWholeTurnIsTheCoefficient) {
  const Real ratio = squared_speed_ratio(0.3, 22.5);  // squared: 1/4 of the exponent
  EXPECT_EQ(sign(ratio * ratio * ratio * ratio - Real::of(0.3)), Sign::uncertain);
  EXPECT_EQ(*squared_speed_ratio(0.125, 30).rational(), Rational(1, 2));
  EXPECT_EQ(*squared_speed_ratio(0.125, 60).rational(), Rational(1, 4));
  EXPECT_EQ(*squared_speed_ratio(0x1p-1074, 45).rational(), Rational(Integer(1), Integer(1) << 537U));
  EXPECT_NE(squared_speed_ratio(0.5, 45).surd(), nullptr);
  EXPECT_EQ(*squared_speed_ratio(0.25, 45).rational(), Rational(1, 2));
  EXPECT_EQ(*squared_speed_ratio(0, 10).rational(), 0);
  EXPECT_EQ(*squared_speed_ratio(1, 10).rational(), 1);
}

TEST(Real, LargeFractionsBecomeBalls) {
  Real x = Real(Rational(1, 3));
  for (int n = 0; n < 15; ++n) x = x * x + Real(1);
  EXPECT_EQ(x.rational(), nullptr);
  const Ball::Ends inside = x.ball().ends();
  EXPECT_LE(inside.lo, inside.hi);
  EXPECT_LT((inside.hi - inside.lo) / inside.lo, Rational(Integer(1), Integer(1) << 400U));
}

/// Sums, products and quotients of random numbers: what is exact lies in the ball of the same expression.
TEST(Real, ExactValuesLieInTheirBalls) {
  std::mt19937_64 random(7);
  const auto small = [&] {
    return Rational(static_cast<int>(random() % 41) - 20, static_cast<int>(random() % 9) + 1);
  };
  int surds = 0;
  for (int n = 0; n < 500; ++n) {
    const Real root = sqrt(Real(Rational(static_cast<int>(random() % 30) + 2)));
    const Real x = Real(small()) + Real(small()) * root, y = Real(small()) + Real(small()) * root;
    if (sign(y) == Sign::zero) continue;
    const Real exactly = x / y + x * y;
    const Ball::Ends ends = (x.ball() / y.ball() + x.ball() * y.ball()).ends();
    surds += exactly.surd() != nullptr ? 1 : 0;
    EXPECT_NE(sign(exactly - Real(ends.lo)), Sign::negative);
    EXPECT_NE(sign(Real(ends.hi) - exactly), Sign::negative);
  }
  EXPECT_GT(surds, 200);
}

}  // namespace
}  // namespace tps::certified
