#include "reference/text/hexfloat.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include "reference/scalars.hpp"
#include "reference/text/append_hex.hpp"
#include "reference/text/number_text.hpp"
#include "reference/text/typed_number.hpp"

namespace tps {
namespace {

TEST(Hexfloat, SpellsAsPrintfDoes) {
  std::mt19937_64 bits(1);
  for (int n = 0; n < 20000; ++n) {
    const std::uint64_t word = bits();
    double x = 0;
    std::memcpy(&x, &word, sizeof x);
    if (std::isnan(x)) continue;
    EXPECT_EQ(from_hex<double>(to_hex(x)), x);
    if (std::isfinite(x)) {
      EXPECT_EQ(join_hex(hex_digits(x)), to_hex(x));
    }
  }
  EXPECT_EQ(to_hex(3.0), "0x1.8p+1");
  EXPECT_EQ(to_hex(-0.1), "-0x1.999999999999ap-4");
  EXPECT_EQ(to_hex(0.0), "0x0p+0");
  EXPECT_EQ(to_hex(-0.0), "-0x0p+0");
  EXPECT_EQ(to_hex(4.9406564584124654e-324), "0x1p-1074");
}

/// Spelt digit by digit, which shares no code with write_hex.
std::string spelt(double x) {
  return std::isinf(x) ? (x > 0 ? "inf" : "-inf") : join_hex(hex_digits(x));
}

/// Of random bits, of short numbers, of subnormal ones, of the edges of the range.
TEST(Hexfloat, AppendsAsItSpells) {
  std::mt19937_64 bits(2);
  for (int n = 0; n < 40000; ++n) {
    double x = std::bit_cast<double>(bits());
    if (n % 3 == 0) x = std::ldexp(double(bits() % 4096), int(bits() % 100) - 50);
    if (n % 16 == 1) x = std::bit_cast<double>(bits() & 0x801f'ffff'ffff'ffffU);
    if (std::isnan(x)) continue;
    std::string text = "x";
    append_hex(text, x);
    ASSERT_EQ(text, "x" + spelt(x));
    text.clear();
    append_hex(text, static_cast<float>(x));
    ASSERT_EQ(text, spelt(static_cast<float>(x)));
  }
  for (const double x :
       {0.0, -0.0, 1.0, HUGE_VAL, -HUGE_VAL, 0x1p-1022, 0x1p-1074, 0x1.fffffffffffffp+1023}) {
    std::string text;
    append_hex(text, x);
    EXPECT_EQ(text, spelt(x));
  }
}

/// Pairs as clocks have them, with gaps, borrows from powers of two, rests that end late; and any others.
TEST(Hexfloat, AppendsExactSums) {
  std::mt19937_64 bits(3);
  const auto expect_sum = [](double hi, double lo) {
    std::string text;
    append_hex_sum(text, hi, lo);
    const std::array<HexDigits, 2> terms = {hex_digits(hi), hex_digits(lo)};
    ASSERT_EQ(text, join_hex(exact_sum(terms))) << to_hex(hi) << " + " << to_hex(lo);
  };
  for (int n = 0; n < 20000; ++n) {
    const double fraction = 1 + double(bits() >> 12U) * 0x1p-52;
    const double hi = std::ldexp(n % 5 == 0 ? 1 : fraction, int(bits() % 40) - 20);
    const double rest = (1 + double(bits() >> 12U) * 0x1p-52) * (n % 2 == 0 ? 1 : -1);
    expect_sum(hi, std::ldexp(hi * rest, -54 - int(bits() % 4) * int(bits() % 12)));
    expect_sum(hi, std::ldexp(hi * (n % 7 - 3), -54));
    expect_sum(hi, rest);
  }
  for (const double lo : {0.0, -0.0, 0x1p-1074, -0x1p-60, 1.0, -1.0, 1e300}) {
    for (const double hi : {0.0, 1.0, 1e300, 0x1p-1022, -3.0}) expect_sum(hi, lo);
  }
}

TEST(Hexfloat, RefusesWhatTheScalarCannotHold) {
  EXPECT_EQ(from_hex<double>("0x1.00000000000008p+0"), std::nullopt);
  EXPECT_EQ(from_hex<double>("0x1p-1075"), std::nullopt);
  EXPECT_EQ(from_hex<double>("0x1p+1024"), std::nullopt);
  EXPECT_EQ(from_hex<float>("0x1.000001p+0"), std::nullopt);
  EXPECT_EQ(from_hex<float>("0x1.000002p+0"), 0x1.000002p+0F);
  for (const char* text : {"", "0x", "1.5", "0x1.8q3", "0x1p", "0x1p+", "0x1p+-1", "0x1p--1", "0x3",
                           "0x1..8p0", "nan", "0x1p99999999999999999999"}) {
    EXPECT_EQ(from_hex<double>(text), std::nullopt) << text;
  }
}

TEST(Hexfloat, ReadsEverySpellingOfTheSameNumber) {
  for (const char* text :
       {"0x1.8p+1", "+0x3P0", "0x3p0", "0X0030p-4", "0x.3p4", "0x1.80000000000000000000p+1"}) {
    EXPECT_EQ(from_hex<double>(text), 3.0) << text;
  }
}

/// One in fifteen is a hexadecimal float; the others are nearly one.
std::string nearly_hex(std::mt19937_64& bits) {
  static const std::array<std::vector<std::string>, 7> parts = {
      {{"", "", "", "", "-", "+", "--"},
       {"0x", "0x", "0x", "0X", "x", ""},
       {"1", "", "0", "0003", "aBc", "1fffffffffffff"},
       {"", ".", ".", "..", ","},
       {"", "8", "0", "fF000", "0000000000001", "g"},
       {"p", "p", "P", "", "e"},
       {"0", "+1", "-1", "1074", "-1074", "+", "", "+-1", "1.0", "01"}}};
  std::string text;
  for (const std::vector<std::string>& choice : parts) text += choice[bits() % choice.size()];
  return text;
}

TEST(Hexfloat, EveryReaderTakesTheSameSpellings) {
  std::mt19937_64 bits(1);
  int taken = 0;
  for (int n = 0; n < 20000; ++n) {
    const std::string text = nearly_hex(bits);
    const std::optional<double> value = from_hex<double>(text);
    const HexFloat strict = parse_hex_float(text);
    const bool is_spelt = hex_spelling(text).has_value();
    EXPECT_EQ(strict.verdict == HexFloat::Verdict::malformed, !is_spelt) << text;
    EXPECT_EQ(split_hex(text).has_value(), is_spelt) << text;
    EXPECT_EQ(strict.verdict == HexFloat::Verdict::exact, value.has_value()) << text;
    if (text.find_first_of("xX") != std::string::npos) {
      EXPECT_EQ(typed_number(text).value, value) << text;
    }
    if (!value) continue;
    ++taken;
    EXPECT_EQ(strict.value, *value) << text;
    EXPECT_EQ(from_hex<Mp50>(text), Mp50(*value)) << text;
    EXPECT_EQ(std::strtod(text.c_str(), nullptr), *value)
        << text << ": a reader that shares no code with ours";
  }
  EXPECT_GT(taken, 1000);
}

template <typename Scalar>
class HexfloatOf : public testing::Test {};
using Wide = testing::Types<float, long double, Quad, Mp50, Mp100>;
TYPED_TEST_SUITE(HexfloatOf, Wide);

TYPED_TEST(HexfloatOf, RoundTrips) {
  using std::sqrt;
  for (int n = 1; n < 200; ++n) {
    const TypeParam x = sqrt(TypeParam(n)) / TypeParam(7) - TypeParam(1);
    EXPECT_EQ(from_hex<TypeParam>(to_hex(x)), x);
  }
}

TEST(Hexfloat, SumIsExact) {
  const std::array<HexDigits, 3> terms = {hex_digits(0x1p+40), hex_digits(-0x1.8p-60), hex_digits(0x1p-200)};
  EXPECT_EQ(join_hex(exact_sum(terms)),
            "0x1.ffffffffffffffffffffffffd00000000000000000000000000000000002p+39");
  const std::array<HexDigits, 2> cancelling = {hex_digits(0.1), hex_digits(-0.1)};
  EXPECT_EQ(join_hex(exact_sum(cancelling)), "0x0p+0");
}

}  // namespace
}  // namespace tps
