// Integers modulo 2^256 beside those of any size, and the verdicts that they give.
#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "verify/exact/double_word_filter.hpp"
#include "verify/exact/lifted_query.hpp"
#include "verify/exact/modular_integer.hpp"
#include "verify/exact/modular_query.hpp"
#include "verify/exact/rounded_time.hpp"
#include "verify/vectors/timing_strata.hpp"

namespace tps::exact {
namespace {

/// Of two's complement: the words of x modulo 2^256 are those of x + 2^256 where x is negative.
bool is_congruent(const ModularInteger& x, const Integer& right) {
  ModularInteger built;
  Integer rest = right;
  const Integer modulus = Integer(1) << 256U;
  rest %= modulus;
  if (rest < 0) rest += modulus;
  for (unsigned n = 0; n < 8; ++n) {
    const auto part = static_cast<std::uint32_t>((rest >> (32 * n)) & 0xffffffffU);
    built = built + ModularInteger(std::int64_t{part}).times_two_to(32 * n);
  }
  return built == x;
}

TEST(ModularInteger, IsAnIntegerModulo2To256) {
  std::mt19937_64 bits(1);
  const auto number = [&] {
    const double x =
        std::ldexp(static_cast<double>(static_cast<std::int64_t>(bits())), int(bits() % 190) - 60);
    return bits() % 16 == 0 ? 0.0 : x;
  };
  for (int n = 0; n < 3000; ++n) {
    const double x = number(), y = number();
    const int unit = -70 - static_cast<int>(bits() % 3);
    const ModularInteger a = ModularInteger::lifted(x, unit), b = ModularInteger::lifted(y, unit);
    const Integer A = lifted(x, unit), B = lifted(y, unit);
    ASSERT_TRUE(is_congruent(a, A)) << x;
    ASSERT_TRUE(is_congruent(a + b, Integer(A + B))) << x << ' ' << y;
    ASSERT_TRUE(is_congruent(a - b, Integer(A - B))) << x << ' ' << y;
    ASSERT_TRUE(is_congruent(a * b, Integer(A * B))) << x << ' ' << y;
    if (bits_of(Integer(A * B)) < 255) {
      ASSERT_EQ((a * b).sign(), Integer(A * B).sign()) << x << ' ' << y;
    }
  }
}

/// Every length of both factors, the ends of the range among them.
TEST(ModularInteger, MultipliesShortIntegers) {
  std::mt19937_64 bits(3);
  const auto number = [&]() -> ShortInteger {
    const ShortInteger x = ShortInteger{static_cast<std::int64_t>(bits())} << 64 | ShortInteger{bits()};
    const ShortInteger shortened = x >> (bits() % 127);
    const ShortInteger largest = ~(ShortInteger{std::numeric_limits<std::int64_t>::min()} << 64);
    switch (bits() % 16) {
      case 0:
        return largest;
      case 1:
        return -largest;
      case 2:
        return ShortInteger{1} << (bits() % 127);
      default:
        return shortened;
    }
  };
  for (int n = 0; n < 20'000; ++n) {
    const ShortInteger x = number(), y = number();
    ASSERT_TRUE(ModularInteger::product(x, y) == ModularInteger(x) * ModularInteger(y)) << n;
  }
}

/// The two words hold what they are said to hold: off by less than 2^-105.
TEST(ModularInteger, IsCutOffToDoubleWords) {
  std::mt19937_64 bits(2);
  for (int n = 0; n < 2000; ++n) {
    ModularInteger x(static_cast<std::int64_t>(bits() >> (bits() % 63)) + 1);
    x = x * ModularInteger(static_cast<std::int64_t>(bits() >> 2U)) *
        ModularInteger(static_cast<std::int64_t>(bits() >> 2U));
    const unsigned shift = static_cast<unsigned>(bits() % 60);
    x = x.times_two_to(shift);
    if (x.sign() <= 0) continue;
    const DoubleWord words = (n % 2 == 0 ? x : -x).magnitude();
    const int unit = std::min(unit_of(words.hi), unit_of(words.lo));
    const ModularInteger kept = ModularInteger::lifted(words.hi, std::min(unit, 0)) +
                                ModularInteger::lifted(words.lo, std::min(unit, 0));
    ASSERT_GE(unit, 0) << "an integer of so many bits is cut off at an integer";
    const ModularInteger rest = x - kept;
    ASSERT_GE(rest.sign(), 0);
    if (rest.sign() > 0) {
      ASSERT_LT(rest.magnitude().hi, words.hi * 0x1p-105);
    }
  }
}

/// In every stratum: verdicts, and times where double words tell them. Nearly all grazes have few enough
/// bits.
TEST(ModularQuery, AnswersAsTheIntegersDo) {
  std::size_t grazes = 0, answered = 0, times = 0;
  const std::vector<strata::Stratum> strata = strata::all(3, 400);
  for (std::size_t n = 0; n < strata.size(); ++n) {
    for (const TimingQuery& query : strata[n].queries) {
      if (!valid(query) || query.kind == Kind::plane || is_static(query)) continue;
      grazes += n == 1 ? 1U : 0U;
      const auto quadratic = modular_quadratic(query, double_word_coefficients(query));
      if (!quadratic) continue;
      answered += n == 1 ? 1U : 0U;
      Counters counters;
      const TimingAnswer right = rounded_time_by_integers(query, counters);
      ASSERT_EQ(verdict_of(query.kind, *quadratic), right.verdict);
      if (!occurs(right.verdict) || at_once(right.verdict)) continue;
      const auto time = rounded_time(query.kind, right.verdict, *quadratic);
      times += time ? 1U : 0U;
      if (time) {
        ASSERT_EQ(*time, *right.t);
      }
    }
  }
  EXPECT_GT(answered, grazes * 9 / 10);
  EXPECT_GT(times, 1000U);
}

}  // namespace
}  // namespace tps::exact
