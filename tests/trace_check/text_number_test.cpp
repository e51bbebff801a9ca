// A time on the scene's clock is read back as the two doubles that were written.
#include "verify/trace_check/text_number.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "reference/trace/event_line.hpp"

namespace tps::check {
namespace {

TEST(TimesAreReadExactly, WhateverTheStart) {
  std::mt19937_64 random(20260101);
  const auto number = [&](int low, int high) {
    const int exponent = low + static_cast<int>(random() % static_cast<std::uint64_t>(high - low + 1));
    return std::ldexp(1 + static_cast<double>(random() >> 12) * 0x1p-52, exponent);
  };
  for (int n = 0; n < 20000; ++n) {
    const bool wide = n % 4 == 0;
    const double hi = number(wide ? -300 : -20, wide ? 300 : 60);
    const double half_ulp = (std::nextafter(hi, HUGE_VAL) - hi) / 2;
    const double lo = half_ulp * (static_cast<double>(random() >> 11) * 0x1p-52 - 1) * (1 - 0x1p-10) *
                      std::ldexp(1.0, -static_cast<int>(random() % 60));
    const double start = n % 5 == 0 ? 0 : n % 3 == 0 ? 0.1 : number(-60, 60) * (n % 2 == 0 ? 1 : -1);
    const std::string text = exact_time(start, Time<double>{hi, lo});
    const auto read = instant_of<double>(text, start);
    ASSERT_TRUE(read.has_value()) << text;
    EXPECT_EQ(read->hi, hi) << text << " from " << start;
    EXPECT_EQ(read->lo, lo) << text << " from " << start;
  }
}

TEST(TimesAreReadExactly, TiesAndRemaindersOfSums) {
  ExactSum sum;
  for (const double x : {1.0, 0x1p-53, 0x1p-120}) sum.add(x);
  EXPECT_EQ(sum.rounded(), 1 + 0x1p-52);
  sum.add(-0x1p-119);
  EXPECT_EQ(sum.rounded(), 1);
  sum.add(0x1p-120);
  EXPECT_EQ(sum.rounded(), 1);  // the middle, to even
  sum.add(-1);
  EXPECT_EQ(sum.rounded(), 0x1p-53);
}

// start_time + t may be no double where both are.
TEST(TimesAreReadExactly, BeyondTheRangeOfDoublesButNotOfTheClock) {
  constexpr double kLargest = std::numeric_limits<double>::max();
  for (const double start : {kLargest, 0x1.3p1023, 1e308}) {
    for (const double hi : {kLargest, 0x1.1ccf385ebc8ap+1023, 0x1.8p1022}) {
      for (const double lo : {0., 0x1p960, -0x1.8p900, 0x1p-1000}) {
        const std::string text = exact_time(start, Time<double>{hi, lo});
        for (const char* sign : {"", "-"}) {
          const double factor = *sign == '-' ? -1 : 1;
          const auto read = instant_of<double>(sign + text, factor * start);
          ASSERT_TRUE(read.has_value()) << text;
          EXPECT_EQ(read->hi, factor * hi) << text << " from " << start;
          EXPECT_EQ(read->lo, factor * lo) << text << " from " << start;
        }
      }
    }
  }
}

TEST(TimesAreReadExactly, BeyondTheRange) {
  const auto read = instant_of<double>("0x1.8p+1100", 0.1);
  ASSERT_TRUE(read.has_value());
  EXPECT_TRUE(std::isinf(read->hi));
}

}  // namespace
}  // namespace tps::check
