// Digits buy what they should: on every stratum the error of the reference's formula is at most k u cond with
// one k for all scalars, so it shrinks as 2^-p from 24 to 334 bits (docs/accuracy-cost.md, "The bound").
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/cost/stratum_questions.hpp"
#include "verify/cost/exact_answer.hpp"
#include "verify/cost/variant.hpp"
#include "verify/vectors/timing_strata.hpp"

namespace tps::cost {
namespace {

constexpr double kBound = 80;            ///< units of u cond: derived on the page
constexpr double kFirstOrder = 0x1p-12;  ///< of u cond: beyond it the bound says nothing
constexpr int kQuestions = 120;
constexpr int kEnough = 15;  ///< compared, of those: most strata have contacts and misses, too

struct Scaled {
  double worst = 0;  ///< the largest error in units of u cond
  int compared = 0;
  std::string where;
};

Scaled worst_error(const std::vector<TimingQuery>& queries, const Variant& variant) {
  Scaled result;
  const double u = std::ldexp(1.0, -variant.bits);
  for (const TimingQuery& query : queries) {
    const ExactAnswer exact(query);
    const Answer answer = variant.answer(query);
    if (!exact.condition() || !answer.t || answer.verdict != exact.verdict()) continue;
    if (*exact.condition() * u > kFirstOrder) continue;
    ++result.compared;
    const double units =
        std::exp2(exact.log2_error(*answer.t) + variant.bits - std::log2(*exact.condition()));
    if (units <= result.worst) continue;
    result.worst = units;
    result.where = exact::strata::text(query);
  }
  return result;
}

class Stability : public testing::TestWithParam<Hazard> {};

TEST_P(Stability, ErrorsShrinkAsTheUnitRoundoff) {
  const int fewest = asked(GetParam().name).fewest_bits;
  const std::vector<TimingQuery> queries = questions_for(GetParam().name, kQuestions);
  int scalars = 0;
  for (const Variant& variant : variants()) {
    if (variant.formula != "stable" || variant.bits < fewest) continue;
    const Scaled seen = worst_error(queries, variant);
    EXPECT_LE(seen.worst, kBound) << variant.name << ": " << seen.where;
    EXPECT_GE(seen.compared, kEnough) << variant.name;
    ++scalars;
  }
  EXPECT_EQ(scalars, fewest == 113 ? 5 : fewest == 53 ? 7 : 8);
}

INSTANTIATE_TEST_SUITE_P(Strata, Stability, testing::ValuesIn(hazards()),
                         [](const auto& hazard) { return hazard.param.name; });

/// Eleven bits short, as a constant in double would leave a long double.
TEST(StabilityBound, SeesLostDigits) {
  Variant pretender = variants().front();
  ASSERT_EQ(pretender.bits, 53);
  pretender.bits = 64;
  EXPECT_GT(worst_error(questions_for("plain", kQuestions), pretender).worst, kBound);
}

}  // namespace
}  // namespace tps::cost
