#include "reference/text/hexfloat.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <random>

#include "reference/scalars.hpp"

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

TEST(Hexfloat, RefusesWhatTheScalarCannotHold) {
  EXPECT_EQ(from_hex<double>("0x1.00000000000008p+0"), std::nullopt);
  EXPECT_EQ(from_hex<double>("0x1p-1075"), std::nullopt);
  EXPECT_EQ(from_hex<double>("0x1p+1024"), std::nullopt);
  EXPECT_EQ(from_hex<float>("0x1.000001p+0"), std::nullopt);
  EXPECT_EQ(from_hex<float>("0x1.000002p+0"), 0x1.000002p+0F);
  for (const char* text :
       {"", "0x", "1.5", "0x1.8q3", "0x1p", "0x1p+", "0x1..8p0", "nan", "0x1p99999999999999999999"}) {
    EXPECT_EQ(from_hex<double>(text), std::nullopt) << text;
  }
}

TEST(Hexfloat, ReadsEverySpellingOfTheSameNumber) {
  for (const char* text :
       {"0x1.8p+1", "0x3", "0x3p0", "0X0030p-4", "0x.3p4", "0x1.80000000000000000000p+1"}) {
    EXPECT_EQ(from_hex<double>(text), 3.0) << text;
  }
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
