// Counter-based random numbers: Random123's known answers, and the moments of the normal method.
#include "reference/scene/random.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tps {
namespace {

// From the file kat_vectors of the Random123 distribution, "philox4x32 10"; words 1 and 0 of each result.
TEST(Random, MatchesTheKnownAnswersOfPhilox) {
  EXPECT_EQ(draw_bits(0, Purpose{0}, 0, 0, 0), 0xe169c58d6627e8d5U);
  EXPECT_EQ(draw_bits(~std::uint64_t{0}, Purpose{0xffffffff}, 0xffffffff, 0xffffffff, 0xffffffff),
            0x41c83b0e408f276dU);
  EXPECT_EQ(draw_bits(0x299f31d0a4093822, Purpose{0x243f6a88}, 0x85a308d3, 0x13198a2e, 0x03707344),
            0x94fdccebd16cfe09U);
}

TEST(Random, UniformCoversTheHalfOpenIntervalExactly) {
  EXPECT_EQ(uniform_of_bits(0), 0.0);
  EXPECT_EQ(uniform_of_bits(std::uint64_t{1} << 11), 0x1p-53);
  EXPECT_EQ(uniform_of_bits(~std::uint64_t{0}), 1 - 0x1p-53);
}

TEST(Random, StreamsCountTheirDraws) {
  RandomStream stream{7, Purpose::tether_form, 1, 2, 0};
  EXPECT_EQ(next_uniform(stream), uniform(7, Purpose::tether_form, 1, 2, 0));
  EXPECT_EQ(next_uniform(stream), uniform(7, Purpose::tether_form, 1, 2, 1));
  EXPECT_NE(uniform(7, Purpose::tether_form, 1, 2, 0), uniform(7, Purpose::tether_break, 1, 2, 0));
  EXPECT_NE(uniform(7, Purpose::tether_form, 1, 2, 0), uniform(7, Purpose::tether_form, 2, 1, 0));
}

TEST(Random, NormalHasTheMomentsAndTailsOfTheNormalDistribution) {
  constexpr int kDraws = 200000;
  RandomStream stream{1, Purpose::scene_velocity, 0, 0, 0};
  double first = 0, second = 0, fourth = 0;
  int beyond_one = 0, beyond_two = 0;
  for (int i = 0; i < kDraws; ++i) {
    const double x = next_normal(stream);
    first += x;
    second += x * x;
    fourth += x * x * x * x;
    beyond_one += std::abs(x) > 1 ? 1 : 0;
    beyond_two += std::abs(x) > 2 ? 1 : 0;
  }
  // Four standard errors each: of x 1, of x² sqrt(2), of x⁴ sqrt(96), of an indicator sqrt(p(1-p)).
  const double error = 4 / std::sqrt(kDraws);
  EXPECT_NEAR(first / kDraws, 0, error);
  EXPECT_NEAR(second / kDraws, 1, error * std::sqrt(2.0));
  EXPECT_NEAR(fourth / kDraws, 3, error * std::sqrt(96.0));
  EXPECT_NEAR(beyond_one / double{kDraws}, 0.31731, error * std::sqrt(0.3173 * 0.6827));
  EXPECT_NEAR(beyond_two / double{kDraws}, 0.04550, error * std::sqrt(0.0455 * 0.9545));
}

// Four standard errors each: of x 1, of x² sqrt(20), of an indicator sqrt(p(1-p)).
TEST(Random, ExponentialHasTheMomentsAndTailOfTheExponentialDistribution) {
  constexpr int kDraws = 200000;
  RandomStream stream{1, Purpose::random_impulse_wait, 0, 0, 0};
  double first = 0, second = 0;
  int beyond_two = 0;
  for (int i = 0; i < kDraws; ++i) {
    const double x = next_exponential(stream);
    first += x;
    second += x * x;
    beyond_two += x > 2 ? 1 : 0;
  }
  const double error = 4 / std::sqrt(kDraws), p = std::exp(-2);
  EXPECT_NEAR(first / kDraws, 1, error);
  EXPECT_NEAR(second / kDraws, 2, error * std::sqrt(20.0));
  EXPECT_NEAR(beyond_two / double{kDraws}, p, error * std::sqrt(p * (1 - p)));
  EXPECT_NEAR(stream.n / double{kDraws}, std::exp(1) / (1 - std::exp(-1)), 0.1) << "draws a number";
}

// Mean and variance k; the fourth central moment is 3k² + 6k, so that x − k squared has variance 2k² + 6k.
TEST(Random, GammaHasTheMomentsOfItsShape) {
  constexpr int kDraws = 100000;
  for (const double shape : {0.3, 0.9, 1.0, 2.5, 40.0}) {
    RandomStream stream{1, Purpose::random_impulse, 0, 0, 0};
    double first = 0, second = 0, logarithm = 0;
    for (int i = 0; i < kDraws; ++i) {
      const double x = next_gamma(stream, shape);
      ASSERT_GE(x, 0);
      first += x;
      second += (x - shape) * (x - shape);
      logarithm += std::log(x);
    }
    const double error = 4 / std::sqrt(kDraws);
    EXPECT_NEAR(first / kDraws, shape, error * std::sqrt(shape)) << shape;
    EXPECT_NEAR(second / kDraws, shape, error * std::sqrt(2 * shape * shape + 6 * shape)) << shape;
    // ⟨ln x⟩ is the derivative of ln Γ, by a symmetric difference; its variance is below 1/k + 1/k².
    const double digamma = (std::lgamma(shape + 1e-4) - std::lgamma(shape - 1e-4)) / 2e-4;
    EXPECT_NEAR(logarithm / kDraws, digamma, error * std::sqrt(1 / shape + 1 / (shape * shape))) << shape;
  }
}

}  // namespace
}  // namespace tps
