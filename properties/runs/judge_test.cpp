// How numbers of traces are read: both parts together are the number, whatever its length.
#include "properties/runs/judge.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "reference/text/hexfloat.hpp"

namespace tps::properties::runs {
namespace {

/// The number that a text spells less both parts, exactly.
HexDigits left_behind(const std::string& text, const Instant& parts) {
  const std::array<HexDigits, 3> terms = {split_hex(text).value(), hex_digits(-parts.hi),
                                          hex_digits(-parts.lo)};
  return exact_sum(terms);
}

/// The power of two at or below a number that is not 0.
long size_of(const HexDigits& number) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  const long leading = std::ilogb(static_cast<double>(kDigits.find(number.digits.front())));
  return number.exponent + 4 * static_cast<long>(number.digits.size() - 1) + leading;
}

TEST(NumbersOfTraces, AreReadInTwoParts) {
  std::mt19937_64 random(1);
  int in_one = 0, in_two = 0, rounded = 0;
  for (int n = 0; n < 20'000; ++n) {
    const std::uint64_t kind = random() % 3;
    std::string text = random() % 2 == 0 ? "-0x1." : "0x1.";
    for (std::uint64_t k = 0, digits = 1 + random() % 45; k < digits; ++k)
      text += kind == 0 ? 'f' : kind == 1 && k % 20 > 3 ? '0' : "0123456789abcdef"[random() % 16];
    text += "p" + std::to_string(static_cast<int>(random() % 4000) - 2000);
    const HexDigits number = split_hex(text).value();
    const Instant parts = read_instant(text);
    const HexDigits left = left_behind(text, parts);
    // 16 hexadecimal digits hold 61 bits at least, half a unit of the last is left.
    if (parts.lo != 0) {
      EXPECT_LE(std::ilogb(parts.lo), size_of(number) - 61) << text;
    }
    if (!left.digits.empty()) {
      EXPECT_LE(size_of(left), std::ilogb(parts.lo) - 61) << text;
    }
    ++(parts.lo == 0 ? in_one : in_two);
    rounded += left.digits.empty() ? 0 : 1;
    EXPECT_EQ(read_real(text), parts.hi + parts.lo);
  }
  EXPECT_GT(in_one, 1000);
  EXPECT_GT(in_two, 1000);
  EXPECT_GT(rounded, 1000);
}

TEST(NumbersOfTraces, MayBeZeroOrInfiniteAndNothingElse) {
  EXPECT_EQ(read_instant("0x0p+0"), (Instant{0, 0}));
  EXPECT_TRUE(std::isinf(read_instant("inf").hi));
  EXPECT_THROW(read_instant("1.5"), std::invalid_argument);
}

}  // namespace
}  // namespace tps::properties::runs
