// The square root in software scalars, against Boost's own, which goes bit by bit, and against exact squares.
#include "reference/equations/wide_square_root.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "reference/equations/dyadic.hpp"
#include "reference/scalars.hpp"

namespace {

using tps::dyadic;
using tps::Dyadic;
using tps::square_root;

using Wide =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<250>, boost::multiprecision::et_off>;

template <typename Scalar>
class SquareRoot : public ::testing::Test {
 protected:
  static constexpr int kDigits = std::numeric_limits<Scalar>::digits;

  /// All bits random, of either parity of the exponent.
  Scalar any() {
    Scalar x = 0;
    for (int bits = 0; bits < kDigits; bits += 64) x = Scalar(ldexp(x, 64)) + Scalar(random_());
    return ldexp(x, static_cast<int>(random_() % 4000) - 2000);
  }
  std::uint64_t below(std::uint64_t n) { return random_() % n; }

  /// Law 1, told by squares alone: y − step/2 < √x < y + step/2.
  static void expect_nearest(const Scalar& x) {
    const Scalar y = square_root(x);
    EXPECT_EQ(y, Scalar(sqrt(x))) << x.str(0, std::ios::scientific);
    int exponent = 0;
    static_cast<void>(frexp(y, &exponent));
    const Dyadic half_step{1, exponent - kDigits - 1};
    const Dyadic root = dyadic(y), square = dyadic(x);
    EXPECT_GT((square - (root - half_step) * (root - half_step)).sign(), 0) << x.str(0, std::ios::scientific);
    EXPECT_GT(((root + half_step) * (root + half_step) - square).sign(), 0) << x.str(0, std::ios::scientific);
  }

 private:
  std::mt19937_64 random_{20261126};
};

using Scalars = ::testing::Types<tps::Quad, tps::Mp50, tps::Mp100, Wide>;
TYPED_TEST_SUITE(SquareRoot, Scalars);

TYPED_TEST(SquareRoot, IsTheNearestNumber) {
  for (int n = 0; n < 300; ++n) this->expect_nearest(this->any());
}

// Beside squares of numbers of half the digits, and beside powers of two, where steps change.
TYPED_TEST(SquareRoot, IsTheNearestNumberBesideExactOnes) {
  using tps::Rounding;
  for (int n = 0; n < 100; ++n) {
    int exponent = 0;
    const TypeParam fraction = frexp(this->any(), &exponent);
    const TypeParam half = floor(TypeParam(ldexp(fraction, this->kDigits / 2)));
    const TypeParam power = ldexp(TypeParam(1), static_cast<int>(this->below(200)) - 100);
    EXPECT_EQ(square_root(TypeParam(half * half)), half);
    for (const TypeParam& x : {TypeParam(half * half), power}) {
      this->expect_nearest(x);
      this->expect_nearest(tps::next_number(x, Rounding::up));
      this->expect_nearest(tps::next_number(x, Rounding::down));
    }
  }
}

TYPED_TEST(SquareRoot, HoldsAtTheEndsOfTheRange) {
  using Limits = std::numeric_limits<TypeParam>;
  if (Limits::max_exponent < 100000) {  // exact squares of the others would have millions of digits
    this->expect_nearest((Limits::max)());
    this->expect_nearest((Limits::min)());
  }
  EXPECT_EQ(square_root(TypeParam(0)), 0);
  EXPECT_TRUE(signbit(square_root(TypeParam(-TypeParam(0)))));
  EXPECT_EQ(square_root(Limits::infinity()), Limits::infinity());
  EXPECT_TRUE(isnan(square_root(TypeParam(-1))));
  EXPECT_TRUE(isnan(square_root(Limits::quiet_NaN())));
}

}  // namespace
