// What judges the variants agrees with the certified answers, which it shares little with, and measures
// errors that are known.
#include "verify/cost/exact_answer.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "verify/cost/questions.hpp"
#include "verify/cost/variant_of.hpp"
#include "verify/exact/rounded_time.hpp"
#include "verify/vectors/time_bracket.hpp"
#include "verify/vectors/timing_strata.hpp"

namespace tps::cost {
namespace {

using exact::Kind;
using exact::Verdict;

/// A correctly rounded time is within half a unit in the last place: an error of at most 2^-53.
TEST(ExactAnswers, AgreeWithTheCertifiedOnes) {
  int compared = 0;
  for (const Hazard& hazard : hazards()) {
    for (const TimingQuery& query : questions(hazard.name, 3, 40)) {
      const ExactAnswer exact(query);
      exact::Counters counters;
      const exact::TimingAnswer certified = exact::rounded_time(query, counters);
      ASSERT_EQ(exact.verdict(), certified.verdict) << exact::strata::text(query);
      if (!exact.occurs() || exact.at_once() || !exact.in_range()) continue;
      EXPECT_LE(exact.log2_error(exact_number(*certified.t)), -53) << exact::strata::text(query);
      const auto condition = vectors::condition(query, vectors::prove(query));
      ASSERT_TRUE(condition && exact.condition());
      // That one is evaluated in long double at the rounded time; its √D = a t + h may have cancelled.
      if (*condition < 1e3) {
        EXPECT_NEAR(*exact.condition() / *condition, 1, 1e-9) << exact::strata::text(query);
      }
      ++compared;
    }
  }
  EXPECT_GT(compared, 150);
}

/// From (−10, 3) at speed 1 the limit 5 is reached at 6; D = 16, a L² = 25.
TEST(ExactAnswers, MeasureKnownErrors) {
  const ExactAnswer exact(exact::strata::relative(Kind::block, {-10, 3, 0}, {1, 0, 0}, 5));
  EXPECT_EQ(exact.verdict(), Verdict::hit);
  EXPECT_EQ(exact.log2_error(exact_number(6.0)), -1000) << "no error at all";
  EXPECT_EQ(exact.log2_error(exact_number(6 * (1 + 0x1p-40))), -40);
  EXPECT_EQ(exact.log2_error(exact_number(3.0)), -1);
  EXPECT_NEAR(*exact.log2_from_tangency(), std::log2(16.0 / 25), 1e-12);
}

TEST(ExactAnswers, KnowWhatLiesBeyondTheDoubles) {
  const ExactAnswer late(exact::strata::relative(Kind::block, {-0x1p1000, 0, 0}, {0x1p-1000, 0, 0}, 1));
  EXPECT_EQ(late.verdict(), Verdict::hit);
  EXPECT_FALSE(late.in_range());
}

TEST(ExactNumbers, HoldEveryBit) {
  const long double third = 1.0L / 3;
  const ExactNumber number = exact_number(third);
  long double sum = 0;
  for (std::size_t k = number.parts.size(); k-- > 0;) sum += static_cast<long double>(number.parts[k]);
  EXPECT_EQ(std::ldexp(sum, number.exponent), third);
}

}  // namespace
}  // namespace tps::cost
