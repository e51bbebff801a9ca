#include "reference/text/number_text.hpp"
#include "reference/text/hexfloat.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>

namespace tps {
namespace {

using Verdict = HexFloat::Verdict;

double read(const std::string& text) {
  const HexFloat hex = parse_hex_float(text);
  EXPECT_EQ(hex.verdict, Verdict::exact) << text;
  return hex.value;
}

TEST(HexFloat, IsReadExactly) {
  EXPECT_EQ(read("0x1.8p+1"), 3.0);
  EXPECT_EQ(read("-0X.8P2"), -2.0);
  EXPECT_EQ(read("+0x10.p-4"), 1.0);
  EXPECT_EQ(read("0x1.fffffffffffffp+1023"), std::numeric_limits<double>::max());
  EXPECT_EQ(read("0x0.0000000000001p-1022"), std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(read("0x100000000000000000000p-80"), 1.0) << "zeros beyond 64 bits";
  EXPECT_EQ(read("0x0.00000000000000000000000000000001p+128"), 1.0);
  EXPECT_EQ(read("0x0p+99999999999999999999"), 0.0) << "an exponent beyond 64 bits is no matter for zero";
  EXPECT_TRUE(std::signbit(read("-0x0p+0")));
}

TEST(HexFloat, IsRefusedWhereItWouldBeRounded) {
  for (const char* text :
       {"0x1.00000000000008p+0", "0x1p+1024", "0x1p-1075", "0x1.8p-1074", "0x1.fffffffffffff8p+1023",
        "0x1p+99999999999999999999", "0x1p-99999999999999999999", "0x10000000000000000001p+0"}) {
    EXPECT_EQ(parse_hex_float(text).verdict, Verdict::not_a_double) << text;
  }
}

TEST(HexFloat, IsRefusedWhereItIsNone) {
  for (const char* text : {"", "-", "0x", "0xp1", "0x.p1", "0x1", "0x1p", "0x1p+", "0x1p+1 ", " 0x1p+1",
                           "1.5", "0x1..p1", "0x1gp1", "0x1p1.5", "nan", "inf", "--0x1p1", "0x-1p1"}) {
    EXPECT_EQ(parse_hex_float(text).verdict, Verdict::malformed) << text;
  }
}

// Doubles of all exponents, with a fixed seed.
template <typename Check>
void for_many_doubles(Check check) {
  std::mt19937_64 random(1);
  for (int k = 0; k < 20000; ++k) {
    const double value = std::bit_cast<double>(random());
    if (std::isfinite(value)) check(value);
  }
  for (const double value : {0.0, -0.0, 1.0, 0.1, 1e22, 1e23, 5e-324, -std::numeric_limits<double>::max()})
    check(value);
}

TEST(NumberText, HexFloatReadsBackBitForBit) {
  for_many_doubles([](double value) {
    EXPECT_EQ(std::bit_cast<std::uint64_t>(read(to_hex<double>(value))), std::bit_cast<std::uint64_t>(value));
    // A reader that shares no code with ours.
    EXPECT_EQ(std::strtod(to_hex<double>(value).c_str(), nullptr), value);
  });
}

TEST(NumberText, ShortestReadsBackBitForBit) {
  for_many_doubles([](double value) {
    const double back = std::strtod(write_shortest(value).c_str(), nullptr);
    EXPECT_EQ(std::bit_cast<std::uint64_t>(back), std::bit_cast<std::uint64_t>(value))
        << write_shortest(value);
  });
  EXPECT_EQ(write_shortest(0.1), "0.1");
  EXPECT_EQ(write_shortest(-0.0), "-0.0") << "\"-0\" is the integer zero to many readers";
}

TEST(NumberText, HexFloatHasTheFormOfC) {
  EXPECT_EQ(to_hex<double>(3.0), "0x1.8p+1");
  EXPECT_EQ(to_hex<double>(-0.0), "-0x0p+0");
  EXPECT_EQ(to_hex<double>(std::numeric_limits<double>::infinity()), "inf");
}

}  // namespace
}  // namespace tps
