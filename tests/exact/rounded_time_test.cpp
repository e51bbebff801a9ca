// Correctly rounded times against 1500 digits, on every stratum and by both paths.
#include "verify/exact/rounded_time.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <vector>

#include "tests/exact/referee.hpp"
#include "verify/exact/double_filter.hpp"
#include "verify/exact/refined_root.hpp"
#include "verify/vectors/timing_strata.hpp"

namespace tps::exact {
namespace {

using referee::Wide;

constexpr double largest = std::numeric_limits<double>::max();
constexpr double smallest = std::numeric_limits<double>::denorm_min();

/// The middle between a finite double x ≥ 0 and the next larger one, where "the next" after the largest is
/// 2^1024.
Wide middle_above(double x) {
  const Wide step = x == largest ? Wide(ldexp(Wide(1), 971)) : Wide(std::nextafter(x, HUGE_VAL)) - Wide(x);
  return Wide(x) + step / 2;
}

/// −1, 0, 1 by the sign of x − y, where agreement to 480 digits means equality: the algebraic numbers of the
/// strata differ from a middle by more, or not at all.
int compare(const Wide& x, const Wide& y) {
  static const Wide unit = pow(Wide(10), -480);
  const Wide difference = x - y;
  if (abs(difference) <= unit * abs(y)) return 0;
  return difference < 0 ? -1 : 1;
}

bool is_even(double x) {
  std::uint64_t bits = 0;
  static_assert(sizeof bits == sizeof x);
  std::memcpy(&bits, &x, sizeof bits);
  return bits % 2 == 0;
}

/// Whether t is the double nearest to the exact time, ties to even, infinity where 2^1024 is.
testing::AssertionResult nearest(double t, const Wide& exact) {
  if (std::isnan(t) || std::signbit(t)) return testing::AssertionFailure() << "no time: " << t;
  if (t < HUGE_VAL) {
    const int above = compare(exact, middle_above(t));
    if (above > 0 || (above == 0 && !is_even(t))) return testing::AssertionFailure() << t << " is too small";
  }
  if (t > 0) {
    const int below = compare(exact, middle_above(std::nextafter(t, 0.0)));
    if (below < 0 || (below == 0 && !is_even(t))) return testing::AssertionFailure() << t << " is too large";
  }
  return testing::AssertionSuccess();
}

/// How many queries each stage answered.
std::vector<std::uint64_t> counts(const Counters& counters) {
  return {counters.verdict.calls, counters.verdict.uncertain, counters.verdict.exact,
          counters.time.calls,    counters.time.uncertain,    counters.time.exact};
}

class TimeStrata : public testing::TestWithParam<strata::Stratum> {};

TEST_P(TimeStrata, IsTheNearestDouble) {
  for (const TimingQuery& query : GetParam().queries) {
    Counters counters;
    const TimingAnswer answer = rounded_time(query, counters);
    const std::optional<Wide> exact = referee::time(query);
    ASSERT_EQ(answer.t.has_value(), exact.has_value()) << strata::text(query);
    if (!exact) continue;
    EXPECT_TRUE(nearest(*answer.t, *exact)) << strata::text(query);
    const TimingAnswer by_integers = rounded_time_by_integers(query, counters);
    EXPECT_EQ(by_integers.t, answer.t) << strata::text(query);
    EXPECT_EQ(by_integers.verdict, answer.verdict);
  }
}

void expect_the_same_together(std::span<const TimingQuery> queries) {
  std::vector<TimingAnswer> together(queries.size());
  Counters together_counters, alone_counters;
  rounded_times(queries, together, together_counters);
  for (std::size_t n = 0; n < queries.size(); ++n) {
    const TimingAnswer alone = rounded_time(queries[n], alone_counters);
    ASSERT_EQ(together[n].verdict, alone.verdict) << strata::text(queries[n]);
    ASSERT_EQ(together[n].t, alone.t) << strata::text(queries[n]);
  }
  EXPECT_EQ(counts(together_counters), counts(alone_counters));
}

// Fours of every beginning, so that each query is the first, second, third and fourth of four, or left over.
TEST_P(TimeStrata, AreTheSameAskedTogether) {
  const std::span<const TimingQuery> queries = GetParam().queries;
  for (std::size_t first = 0; first < 4; ++first) expect_the_same_together(queries.subspan(first));
}

INSTANTIATE_TEST_SUITE_P(, TimeStrata, testing::ValuesIn(strata::all(20260102, 150)), strata::Name{});

double time(const TimingQuery& query) {
  Counters counters;
  return rounded_time(query, counters).t.value();
}

TEST(RoundedTime, KnownCases) {
  EXPECT_EQ(time(strata::relative(Kind::block, {-10, 3, 0}, {1, 0, 0}, 5)), 6);
  EXPECT_EQ(time(strata::relative(Kind::tether, {-10, 3, 0}, {1, 0, 0}, 5)), 14);
  EXPECT_EQ(time(strata::relative(Kind::tether, {2, 0, 0}, {-1, 0, 0}, 2)), 4);
  EXPECT_EQ(time(strata::relative(Kind::tether, {-3, 4, 0}, {1, 0, 0}, 4)), 3);
  EXPECT_EQ(time(strata::relative(Kind::tether, {-3, 4, 0}, {3, 0, 0}, 4)), 1);
  EXPECT_EQ(time(strata::relative(Kind::block, {1, 0, 0}, {-1, 0, 0}, 1)), 0);
}

TEST(RoundedTime, ScalingByPowersOfTwo) {
  strata::Random random(12);
  for (int i = 0; i < 200; ++i) {
    const TimingQuery query = strata::plain(random, Kind::tether);
    Counters counters;
    const std::optional<double> t = rounded_time(query, counters).t;
    // 2^-900 and 2^-300: outside the filters' range, inside the normal doubles.
    const std::optional<double> scaled = rounded_time(strata::scaled(query, -900, -300), counters).t;
    if (t && *t > 0x1p-300) {
      EXPECT_EQ(*scaled, std::ldexp(*t, -600));
    }
  }
}

// The textbook root is off by 3.8 %, the cancellation-free one by 3e-16.
TEST(RoundedTime, JustOutsideTheLimit) {
  const TimingQuery query = strata::relative(Kind::block, {1 + 0x1p-50, 0, 0}, {-.75, .4, 0}, 1);
  EXPECT_TRUE(nearest(time(query), *referee::time(query)));
}

// Halfway between two doubles above 2^53: to the one with the even significand.
TEST(RoundedTime, TiesGoToEven) {
  const auto after = [](double whole, double part) {
    return TimingQuery{Kind::block, {0, 0, 0}, {whole, 0, 0}, {0, 0, 0}, {-1, 0, 0}, part};
  };
  EXPECT_EQ(time(after(0x1p53 + 2, 1)), 0x1p53);      // 2^53 + 1 is a tie: to 2^53
  EXPECT_EQ(time(after(0x1p53 + 4, 1)), 0x1p53 + 4);  // 2^53 + 3 is a tie: to 2^53 + 4
  EXPECT_EQ(time(after(0x1p53 + 6, 1)), 0x1p53 + 4);  // 2^53 + 5 is a tie: to 2^53 + 4
}

TEST(RoundedTime, OverflowAndUnderflow) {
  EXPECT_EQ(time(strata::relative(Kind::block, {2, 0, 0}, {-smallest, 0, 0}, 1)), HUGE_VAL);
  EXPECT_EQ(time(strata::relative(Kind::block, {2 * smallest, 0, 0}, {-1, 0, 0}, smallest)), smallest);
  EXPECT_EQ(time(strata::relative(Kind::block, {4 * smallest, 0, 0}, {-2, 0, 0}, smallest)),
            2 * smallest);                                                                        // 1.5: even
  EXPECT_EQ(time(strata::relative(Kind::block, {2 * smallest, 0, 0}, {-2, 0, 0}, smallest)), 0);  // 0.5: even
  EXPECT_EQ(time(strata::relative(Kind::block, {4 * smallest, 0, 0}, {-5, 0, 0}, smallest)),
            smallest);                                                                            // 0.6
  EXPECT_EQ(time(strata::relative(Kind::block, {2 * smallest, 0, 0}, {-4, 0, 0}, smallest)), 0);  // 0.25
  // The largest double, and where rounding takes over to infinity: 2^1024 − 2^970.
  const auto nearly = [](double part) {
    return TimingQuery{Kind::block, {-largest, 0, 0}, {0x1p960, 0, 0}, {0, 0, 0}, {-1, 0, 0}, part};
  };
  EXPECT_EQ(time(nearly(0x1p960)), largest);
  EXPECT_EQ(time(nearly(0x1p900)), largest);
  const TimingQuery tie{Kind::block, {-largest, 0, 0}, {0x1p971, 0, 0}, {0, 0, 0}, {-1, 0, 0}, 0x1p970};
  EXPECT_EQ(time(tie), HUGE_VAL);
  TimingQuery below_tie = tie;
  below_tie.L = std::nextafter(0x1p970, HUGE_VAL);
  EXPECT_EQ(time(below_tie), largest);
}

// The bound of the Newton step holds, and is no more than a few times what occurs.
TEST(RoundedTime, TheErrorBoundHolds) {
  strata::Random random(5);
  double worst = 0;
  for (int i = 0; i < 4000; ++i) {
    const TimingQuery query = i % 2 == 0
                                  ? strata::plain(random, Kind::tether)
                                  : strata::graze(Kind::block, random.integer(5, 40), 1, 100, i % 4 / 2);
    const Coefficients coefficients = double_coefficients(query);
    const std::optional<Verdict> verdict = coefficients.verdict(query.kind);
    if (verdict != Verdict::hit) continue;
    const std::optional<RefinedTime> refined =
        refined_time(query, *verdict, approximate_time(query.kind, *verdict, coefficients));
    if (!refined) continue;
    const Wide exact = *referee::time(query);
    const Wide found = Wide(refined->t) + Wide(refined->correction);
    worst = std::max(worst, static_cast<double>(Wide(abs(found - exact) / refined->error)));
  }
  EXPECT_LT(worst, 1);
  EXPECT_GT(worst, 0.05);
}

TEST(RoundedTime, AskedTogetherTheyAreTheSameOfEverySort) {
  strata::Random random(7);
  std::vector<TimingQuery> queries;
  for (int i = 0; i < 20000; ++i) {
    const Kind kind = random.integer(0, 1) == 0 ? Kind::block : Kind::tether;
    queries.push_back(strata::plain(random, kind));
    if (i % 100 == 7) queries.back().image = {1, 0, -1}, queries.back().edges = {20, 20, 20};
    if (i % 100 == 58) queries.back().kind = Kind::plane, queries.back().normal = {0, 0.6, 0.8};
  }
  expect_the_same_together(queries);
}

TEST(RoundedTime, TheFastPathSettlesNearlyEverything) {
  strata::Random random(6);
  Counters counters;
  for (int i = 0; i < 20000; ++i) rounded_time(strata::plain(random, Kind::tether), counters);
  EXPECT_GT(counters.time.calls, 10000U);
  EXPECT_EQ(counters.time.exact, 0U);
}

}  // namespace
}  // namespace tps::exact
