// Exact sums and products, and quotients rounded either way.
#include "reference/equations/dyadic.hpp"

#include <cmath>
#include <random>

#include "tests/equations/every_scalar.hpp"

namespace tps::test {
namespace {

TEST(Dyadic, SumsAndProductsAreExact) {
  const Dyadic tiny = dyadic(0x1p-1074);
  const Dyadic large = dyadic(0x1p1023);
  EXPECT_EQ((large + tiny - large - tiny).sign(), 0);
  EXPECT_EQ((large + tiny - large).sign(), 1);
  EXPECT_EQ((tiny * tiny - tiny * tiny * dyadic(1.0)).sign(), 0);
  EXPECT_EQ((dyadic(0.1) * dyadic(0.3) - dyadic(0.3) * dyadic(0.1)).sign(), 0);
  EXPECT_NE((dyadic(0.1) + dyadic(0.2) - dyadic(0.3)).sign(), 0);
}

/// a/b lies between its two roundings, which are neighbours or one number.
TEST(Dyadic, QuotientsAreEnclosedByNeighbours) {
  std::mt19937_64 engine(20260101);
  std::uniform_int_distribution<int> exponent(-1060, 1000);
  std::uniform_real_distribution<double> fraction(-2, 2);
  for (int n = 0; n < 20000; ++n) {
    const double a = std::ldexp(fraction(engine), exponent(engine));
    const double b = std::ldexp(fraction(engine), exponent(engine));
    if (b == 0) continue;
    const double down = rounded_quotient<double>(dyadic(a), dyadic(b), Rounding::down);
    const double up = rounded_quotient<double>(dyadic(a), dyadic(b), Rounding::up);
    EXPECT_TRUE(down == up || next_number(down, Rounding::up) == up) << a << ' ' << b;
    const int side = b > 0 ? 1 : -1;
    if (std::isfinite(down)) {
      EXPECT_LE((dyadic(down) * dyadic(b) - dyadic(a)).sign() * side, 0) << a << ' ' << b;
    }
    if (std::isfinite(up)) {
      EXPECT_GE((dyadic(up) * dyadic(b) - dyadic(a)).sign() * side, 0) << a << ' ' << b;
    }
  }
}

TEST(Dyadic, ExactQuotientsAreThemselvesEitherWay) {
  for (const Rounding rounding : {Rounding::down, Rounding::up}) {
    EXPECT_EQ(rounded_quotient<double>(dyadic(6.0), dyadic(-2.0), rounding), -3);
    EXPECT_EQ(rounded_quotient<float>(dyadic(0x1p-149F), dyadic(1.0F), rounding), 0x1p-149F);
  }
  EXPECT_EQ(rounded_quotient<double>(dyadic(0x1p-1074), dyadic(3.0), Rounding::down), 0);
  EXPECT_EQ(rounded_quotient<double>(dyadic(0x1p-1074), dyadic(3.0), Rounding::up), 0x1p-1074);
}

}  // namespace
}  // namespace tps::test
