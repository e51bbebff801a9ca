// Exact verdicts against rationals, on every stratum and by every stage.
#include "verify/exact/exact_verdict.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>

#include "tests/exact/referee.hpp"
#include "verify/exact/double_word_filter.hpp"
#include "verify/exact/lifted_query.hpp"
#include "verify/vectors/timing_strata.hpp"

namespace tps::exact {
namespace {

std::string verdict_name(const TimingQuery& query) {
  Counters counters;
  return std::string(name(exact_verdict(query, counters)));
}

class Strata : public testing::TestWithParam<strata::Stratum> {};

TEST_P(Strata, EveryStageAgreesWithRationals) {
  for (const TimingQuery& query : GetParam().queries) {
    ASSERT_TRUE(valid(query));
    const std::string expected = referee::verdict(query);
    EXPECT_EQ(verdict_name(query), expected) << strata::text(query);
    if (expected == "static") continue;
    const std::optional<Verdict> in_double = double_coefficients(query).verdict(query.kind);
    if (in_double) {
      EXPECT_EQ(name(*in_double), expected);
    }
    const std::optional<Verdict> in_double_words = double_word_coefficients(query).verdict(query.kind);
    if (in_double_words) {
      EXPECT_EQ(name(*in_double_words), expected);
    }
    const LiftedQuadratic quadratic = lifted_quadratic(query, units_of(query));
    EXPECT_EQ(name(verdict_of(query.kind, quadratic)), expected);
  }
}

TEST_P(Strata, ExchangingTheParticlesChangesNothing) {
  for (TimingQuery query : GetParam().queries) {
    const std::string before = verdict_name(query);
    std::swap(query.u_A, query.u_B);
    std::swap(query.v_A, query.v_B);
    EXPECT_EQ(verdict_name(query), before);
  }
}

// Powers of two, and an offset that all the sums can hold: multiples of 2^-20 below 2^10 in size.
TEST(VerdictLaws, ScalingAndOffset) {
  strata::Random random(8);
  const auto rounded = [](Vec3& x, double offset) {
    for (double& component : x) component = std::ldexp(std::round(std::ldexp(component, 20)), -20) + offset;
  };
  for (int i = 0; i < 500; ++i) {
    TimingQuery query = strata::plain(random, i % 2 == 0 ? Kind::block : Kind::tether);
    for (Vec3* x : {&query.u_A, &query.u_B, &query.v_A, &query.v_B}) rounded(*x, 0);
    const std::string before = verdict_name(query);
    EXPECT_EQ(verdict_name(strata::scaled(query, 700, -650)), before);
    TimingQuery moved = query;
    rounded(moved.u_A, 1000);
    rounded(moved.u_B, 1000);
    rounded(moved.v_A, -517);
    rounded(moved.v_B, -517);
    EXPECT_EQ(verdict_name(moved), before);
  }
}

INSTANTIATE_TEST_SUITE_P(, Strata, testing::ValuesIn(strata::all(20260101, 300)), strata::Name{});

TEST(Verdict, KnownCases) {
  EXPECT_EQ(verdict_name(strata::relative(Kind::block, {1, 0, 0}, {1, 0, 0}, 1)), "receding");
  EXPECT_EQ(verdict_name(strata::relative(Kind::block, {1, 0, 0}, {-1, 0, 0}, 1)), "contact");
  EXPECT_EQ(verdict_name(strata::relative(Kind::block, {1, 0, 0}, {-1, 0, 0}, 1.5)), "overlap");
  EXPECT_EQ(verdict_name(strata::relative(Kind::tether, {2, 0, 0}, {-1, 0, 0}, 2)), "hit");
  EXPECT_EQ(verdict_name(strata::relative(Kind::tether, {2, 0, 0}, {0, 1, 0}, 2)), "taut");
  EXPECT_EQ(verdict_name(strata::relative(Kind::tether, {3, 0, 0}, {0, 1, 0}, 2)), "overstretched");
  EXPECT_EQ(verdict_name(strata::relative(Kind::tether, {-3, 4, 0}, {1, 0, 0}, 4)), "turning");
  EXPECT_EQ(verdict_name(strata::relative(Kind::tether, {-3, 4, 0}, {1, 0, 0}, 4.5)), "hit");
  EXPECT_EQ(verdict_name(strata::relative(Kind::tether, {-3, 4, 0}, {0, 0, 0}, 4)), "static");
}

// The literal discriminant is 0.0 on both sides from x0 = 1e4 on.
TEST(Verdict, GrazeBesideItsMirrorImage) {
  for (const double x0 : {1.0, 1e4, 1e8, 1e15}) {
    EXPECT_EQ(verdict_name(strata::relative(Kind::block, {-x0, 1 - 0x1p-30, 0}, {1, 0, 0}, 1)), "hit");
    EXPECT_EQ(verdict_name(strata::relative(Kind::block, {-x0, 1, 0}, {1, 0, 0}, 1)), "tangent");
    EXPECT_EQ(verdict_name(strata::relative(Kind::block, {-x0, 1 + 0x1p-30, 0}, {1, 0, 0}, 1)), "miss");
  }
}

// r = u_B − u_A loses the last bit here; the verdict is that of the stored positions.
TEST(Verdict, TheDifferenceOfPositionsIsNotRounded) {
  TimingQuery query{Kind::block, {1, 0, 0}, {-0x1p60, 0, 0}, {0, 0, 0}, {1, 0, 0}, 0x1p60};
  EXPECT_EQ(verdict_name(query), "hit");
  query.u_A[0] = 0;
  EXPECT_EQ(verdict_name(query), "contact");
  query.u_A[0] = -1;
  EXPECT_EQ(verdict_name(query), "overlap");
}

TEST(Verdict, OverTheWholeRangeOfDouble) {
  constexpr double max = std::numeric_limits<double>::max();
  constexpr double tiny = std::numeric_limits<double>::denorm_min();
  const TimingQuery huge{Kind::block, {-max, 0, 0}, {max, 0, 0}, {max, 0, 0}, {-max, 0, 0}, max};
  EXPECT_EQ(verdict_name(huge), "hit");
  EXPECT_EQ(verdict_name(strata::relative(Kind::block, {2 * tiny, 0, 0}, {-tiny, 0, 0}, tiny)), "hit");
  EXPECT_EQ(verdict_name(strata::relative(Kind::block, {tiny, 0, 0}, {-tiny, 0, 0}, tiny)), "contact");
  EXPECT_EQ(verdict_name(strata::relative(Kind::block, {max, tiny, 0}, {-tiny, 0, 0}, tiny)), "tangent");
}

// Which stage settles a question is part of the promise: the cheapest that can.
TEST(Verdict, TheCheapestSufficientStageAnswers) {
  const auto counts = [](const TimingQuery& query) {
    Counters counters;
    exact_verdict(query, counters);
    return counters.verdict;
  };
  const StageCounts plain = counts(strata::relative(Kind::block, {2, 0, 0}, {-1, 0, 0}, 1));
  EXPECT_EQ(plain.calls, 1U);
  EXPECT_EQ(plain.uncertain, 0U);
  const StageCounts graze = counts(strata::graze(Kind::block, 50, 1, 1000, 0));
  EXPECT_EQ(graze.uncertain, 1U);
  EXPECT_EQ(graze.exact, 0U);
  const StageCounts tangent = counts(strata::graze(Kind::block, 0, 0, 1000, 0));
  EXPECT_EQ(tangent.uncertain, 1U);
  EXPECT_EQ(tangent.exact, 1U);
}

TEST(Verdict, StrataReachEveryStage) {
  std::map<std::string, StageCounts> reached;
  Counters total;
  for (const strata::Stratum& stratum : strata::all(7, 200)) {
    Counters counters;
    for (const TimingQuery& query : stratum.queries) exact_verdict(query, counters);
    reached[stratum.name] = counters.verdict;
    total.largest_bits = std::max(total.largest_bits, counters.largest_bits);
  }
  EXPECT_EQ(reached["plain"].uncertain, 0U);
  EXPECT_GT(reached["graze"].uncertain - reached["graze"].exact, 50U);
  EXPECT_GT(reached["touching"].uncertain - reached["touching"].exact, 50U);
  EXPECT_GT(reached["tangent"].exact, 50U);
  EXPECT_GT(reached["wide"].exact, 150U);
  EXPECT_GT(total.largest_bits, 6000U);
}

}  // namespace
}  // namespace tps::exact
