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

// √2 √2 is 2, but intervals do not know it: 2 lies inside, its neighbours are the ends.
TEST(Enclosure, ADoubleThatIsNotProvenLiesBetweenItsNeighbours) {
  const Enclosure two = enclosure(sqrt(Real(2)) * sqrt(Real(2)));
  EXPECT_EQ(two.lo, std::nextafter(2.0, 0));
  EXPECT_EQ(two.hi, std::nextafter(2.0, 3));
  EXPECT_EQ(two.nearest, 2);
  EXPECT_TRUE(two.settled);

  const Enclosure zero = enclosure(sqrt(Real(2)) * sqrt(Real(2)) - Real(2));
  EXPECT_LT(zero.lo, 0);
  EXPECT_GT(zero.hi, 0);
  EXPECT_LT(zero.hi - zero.lo, 1e-118);
  EXPECT_EQ(zero.nearest, 0);
  EXPECT_FALSE(zero.settled);

  const Enclosure middle = enclosure(sqrt(Real(2)) * sqrt(Real(2)) + power_of_two(-52));
  EXPECT_EQ(middle.nearest, 2);
  EXPECT_FALSE(middle.settled);
}

TEST(Real, RootsOfSquaresAreExact) {
  ASSERT_NE(sqrt(Real(Rational(9, 16))).rational(), nullptr);
  EXPECT_EQ(*sqrt(Real(Rational(9, 16))).rational(), Rational(3, 4));
  EXPECT_EQ(sqrt(Real(Rational(9, 17))).rational(), nullptr);
}

TEST(Real, ExactAnglesAreThoseOfNiven) {
  EXPECT_EQ(*cos_squared_degrees(30).rational(), Rational(3, 4));
  EXPECT_EQ(*cos_squared_degrees(45).rational(), Rational(1, 2));
  EXPECT_EQ(*cos_squared_degrees(60).rational(), Rational(1, 4));
  EXPECT_EQ(cos_squared_degrees(59).rational(), nullptr);
  // cos² 72° = ((√5 − 1)/4)²
  const Real golden = (sqrt(Real(5)) - Real(1)) / Real(4);
  EXPECT_EQ(sign(cos_squared_degrees(72) - golden * golden), Sign::uncertain);
  EXPECT_EQ(sign(cos_squared_degrees(std::nextafter(72.0, 73.0)) - golden * golden), Sign::negative);
}

TEST(Real, SpeedRatioOfAWholeTurnIsTheCoefficient) {
  const Real ratio = squared_speed_ratio(0.3, 22.5);  // squared: 1/4 of the exponent
  EXPECT_EQ(sign(ratio * ratio * ratio * ratio - Real::of(0.3)), Sign::uncertain);
  EXPECT_EQ(*squared_speed_ratio(0.25, 45).rational(), Rational(1, 2));
  EXPECT_EQ(*squared_speed_ratio(0, 10).rational(), 0);
  EXPECT_EQ(*squared_speed_ratio(1, 10).rational(), 1);
}

TEST(Real, LargeFractionsBecomeIntervals) {
  Real x = Real(Rational(1, 3));
  for (int n = 0; n < 15; ++n) x = x * x + Real(1);
  EXPECT_EQ(x.rational(), nullptr);
  const Interval inside = x.interval();
  EXPECT_LE(inside.lo, inside.hi);
  EXPECT_LT((inside.hi - inside.lo) / inside.lo, Wide("1e-115"));
}

}  // namespace
}  // namespace tps::certified
