// The numbers of the check: times as a run's clock has them.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "reference/engine/clock.hpp"
#include "verify/trace_check/context.hpp"
#include "verify/trace_check/pair_flight.hpp"
#include "verify/trace_check/wide.hpp"

namespace tps::check {
namespace {

/// A float's time as the check reads it from the trace: exactly, in two doubles.
Instant<double> lifted(const Time<float>& t) {
  const exact::DoubleWord sum = exact::two_sum<double>(t.hi, t.lo);
  return {sum.hi, sum.lo};
}

TEST(Number, TimesOfFloatsAreTakenApartAsTheRunHasThem) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> exponent(-30, 30);
  for (int n = 0; n < 20'000; ++n) {
    Time<float> t;
    for (int k = 0; k < 6; ++k) {
      t = after(t, static_cast<float>(std::exp2(exponent(random))));
      const Instant<float> apart = in_floats(lifted(t));
      ASSERT_EQ(apart.hi, t.hi) << n;
      ASSERT_EQ(apart.lo, t.lo) << n;
    }
  }
}

// In the middle between two numbers to the even one, as arithmetic rounds.
TEST(Number, ReadingsOfWideTimesRoundHalfToEven) {
  const Precision<Wide> long_double{ldexp(Wide(1), -64), Wide(0), 64, false};
  std::mt19937_64 random(2);
  for (int n = 0; n < 2'000; ++n) {
    const auto hi = std::ldexp(static_cast<long double>(random() | (std::uint64_t{1} << 63U)), n % 40 - 60);
    const long double half_ulp = std::ldexp(1.0L, std::ilogb(hi) - 64);
    for (const long double lo : {half_ulp, -half_ulp, half_ulp / 2, 0.0L}) {
      const Wide t = Wide(hi) + Wide(lo);
      EXPECT_EQ(reading(Instant<Wide>{t, Wide(0)}, long_double), Wide(hi + lo))
          << n << ' ' << static_cast<double>(lo);
    }
  }
}

// A message about two numbers that differ shows where.
TEST(Number, UnequalNumbersDoNotPrintAsEqual) {
  double x = 2.98176768;
  for (int n = 0; n < 200; ++n) {
    const double y = std::nextafter(x, 4.0);
    const auto [a, b] = told_apart(x, y);
    EXPECT_NE(a, b);
    const auto [c, d] =
        told_apart(static_cast<long double>(x), std::nextafter(static_cast<long double>(x), 4.0L));
    EXPECT_NE(c, d);
    const auto [e, f] = told_apart(Wide(x), Wide(Wide(x) + ldexp(Wide(1), -700)));
    EXPECT_NE(e, f);
    x = y * 1.01;
  }
  EXPECT_EQ(told_apart(1.5, 2.5).first, "1.5");
}

}  // namespace
}  // namespace tps::check
