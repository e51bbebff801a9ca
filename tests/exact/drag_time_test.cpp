// The comparison of −ln(1 − γs)/γ with a number: against long double where that tells, at both ends of the
// range, and beside ties, which no arithmetic of a fixed width decides.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "verify/exact/drag_time.hpp"

namespace tps::exact {
namespace {

TEST(DragTime, AgreesWithLongDoubleWhereThatTells) {
  std::mt19937_64 random(1);
  const auto between = [&](double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(random);
  };
  for (int n = 0; n < 400; ++n) {
    const double gamma = std::ldexp(between(1, 2), static_cast<int>(between(-20, 20)));
    const double s = between(0, 1) / gamma * (1 - 1e-9);
    const long double t = -std::log1p(-static_cast<long double>(gamma) * s) / gamma;
    const auto below = static_cast<double>(t * (1 - 1e-14L));
    const auto above = static_cast<double>(t * (1 + 1e-14L));
    EXPECT_EQ(compare_drag_time(gamma, dyadic(s), dyadic(below)), Sign::positive);
    EXPECT_EQ(compare_drag_time(gamma, dyadic(s), dyadic(above)), Sign::negative);
  }
}

// t = s (1 + γs/2 + …) is above s by less than any double tells, and never s itself.
TEST(DragTime, TellsWhatNoFixedWidthDoes) {
  const double tiny = 0x1p-1000;
  EXPECT_EQ(compare_drag_time(tiny, dyadic(1.0), dyadic(1.0)), Sign::positive);
  EXPECT_EQ(compare_drag_time(tiny, dyadic(1.0), dyadic(1.0) + Dyadic{1, -999}), Sign::negative);
  // A tie of s: 1 + 2⁻⁵³ lies between two doubles, t above it.
  const Dyadic tie = dyadic(1.0) + Dyadic{1, -53};
  EXPECT_TRUE(is_nearest_drag_time(tiny, tie, 0, std::nextafter(1.0, 2)));
  EXPECT_FALSE(is_nearest_drag_time(tiny, tie, 0, 1));
}

TEST(DragTime, EndsOfTheRange) {
  EXPECT_EQ(compare_drag_time(1, Dyadic{}, Dyadic{}), Sign::zero);
  EXPECT_TRUE(is_nearest_drag_time(1, Dyadic{}, 3, 3));
  EXPECT_FALSE(is_nearest_drag_time(1, Dyadic{}, 3, std::nextafter(3.0, 4)));
  const double last = std::nextafter(1.0, 0);  // t = 53 ln 2
  const auto t = static_cast<double>(53 * std::log(2.0L));
  EXPECT_TRUE(is_nearest_drag_time(1, dyadic(last), 0, t));
  EXPECT_FALSE(is_nearest_drag_time(1, dyadic(last), 0, std::nextafter(t, 0)));
  EXPECT_FALSE(is_nearest_drag_time(1, dyadic(last), 0, std::nextafter(t, 99)));
  constexpr double kLargest = std::numeric_limits<double>::max();
  for (const double end : {-kLargest, kLargest}) {
    const double inwards = std::nextafter(end, 0);
    EXPECT_TRUE(is_nearest_drag_time(1, dyadic(.5), end, end));
    EXPECT_FALSE(is_nearest_drag_time(1, dyadic(.5), end, inwards));
    EXPECT_FALSE(is_nearest_drag_time(1, dyadic(.5), inwards, end));
    EXPECT_TRUE(is_nearest_drag_time(1, dyadic(.5), inwards, inwards));
    EXPECT_EQ((middle_of(end, std::copysign(HUGE_VAL, end)) - dyadic(end)).sign(), end < 0 ? -1 : 1);
  }
}

}  // namespace
}  // namespace tps::exact
