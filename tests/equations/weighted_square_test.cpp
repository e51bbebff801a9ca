// Energies whose squares leave the scalar, in float, against long double, whose range holds all of them.
#include "reference/equations/weighted_square.hpp"

#include <gtest/gtest.h>

#include <random>

namespace tps {
namespace {

class WeightedSquare : public testing::Test {
 protected:
  /// Any size of a float that is a normal number.
  float any() {
    const int exponent = static_cast<int>(random_() % 250U) - 124;
    return std::ldexp(1 + static_cast<float>(random_() % 1024U) / 1024, exponent);
  }
  Vector<float, 3> vector() {
    const float size = any() / 4;
    return {size, size / 2, size * static_cast<float>(random_() % 3U)};
  }

  std::mt19937 random_{1};
};

bool is_normal(long double x) {
  return x >= std::numeric_limits<float>::min() && x <= std::numeric_limits<float>::max() / 4;
}

TEST_F(WeightedSquare, IsRightWhereverItsResultIsANumber) {
  int beyond = 0;
  for (int n = 0; n < 4000; ++n) {
    const float m = any();
    const Vector<float, 3> x = vector();
    const long double square = x.cast<long double>().squaredNorm();
    const long double times = static_cast<long double>(m) * square;
    const long double over = square / static_cast<long double>(m);
    beyond += is_normal(square) ? 0 : 1;
    // Three squares, two sums, a product: 4u; sizes within a factor of 4 of the smallest mass cost two bits.
    constexpr long double kBound = 16 * 0x1p-24L;
    if (is_normal(times)) {
      const auto found = static_cast<long double>(weighted_square<float, 3>(m, x));
      EXPECT_LE(std::fabs(found - times), kBound * times) << m << ' ' << x.transpose();
    }
    if (is_normal(over)) {
      const auto found = static_cast<long double>(square_over<float, 3>(x, m));
      EXPECT_LE(std::fabs(found - over), kBound * over) << m << ' ' << x.transpose();
    }
  }
  EXPECT_GE(beyond, 1000);
}

TEST_F(WeightedSquare, HasTheBitsOfThePlainFormulaInTheMiddle) {
  for (int n = 0; n < 1000; ++n) {
    const float m = n % 2 == 0 ? 3.25F : .7F;
    const Vector<float, 2> x{static_cast<float>(random_() % 1000U) / 7, static_cast<float>(n) / 3};
    EXPECT_EQ((weighted_square<float, 2>(m, x)), m * x.squaredNorm());
    EXPECT_EQ((square_over<float, 2>(x, m)), x.squaredNorm() / m);
  }
  EXPECT_EQ((square_over<float, 2>({3, 4}, HUGE_VALF)), 0);
}

}  // namespace
}  // namespace tps
