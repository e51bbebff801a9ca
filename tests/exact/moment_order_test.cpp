// Exact order of moments of a run, whose queries are asked at different instants, against 1500 digits.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/exact/referee.hpp"
#include "verify/exact/rounded_time.hpp"
#include "verify/exact/time_order.hpp"
#include "verify/vectors/timing_strata.hpp"

namespace tps::exact {
namespace {

using referee::Wide;

std::string moments_in_order(const Moment& first, const Moment& second) {
  Counters counters, of_known;
  const Order order = moment_order(first, second, counters);
  // With verdicts found before it is the same, by the same stage.
  EXPECT_EQ(moment_order(known_moment(first, of_known), known_moment(second, of_known), of_known), order);
  EXPECT_EQ(of_known.order.uncertain, counters.order.uncertain);
  EXPECT_EQ(of_known.order.exact, counters.order.exact);
  return std::string(name(order));
}

std::optional<Wide> wide_moment(const Moment& moment) {
  const std::optional<Wide> t = moment.query ? referee::time(*moment.query) : Wide(0);
  if (!t) return std::nullopt;
  return Wide(moment.hi) + Wide(moment.lo) + moment.multiple * *t;
}

std::string expected_order_of(const Moment& first, const Moment& second) {
  static const Wide unit = pow(Wide(10), -1400);
  const std::optional<Wide> t1 = wide_moment(first);
  const std::optional<Wide> t2 = wide_moment(second);
  if (!t1 && !t2) return "none";
  if (!t1 || !t2) return t1 ? "before" : "after";
  if (abs(*t1 - *t2) <= unit * (abs(*t1) + abs(*t2))) return "equal";
  return *t1 < *t2 ? "before" : "after";
}

void expect_moments(const Moment& first, const Moment& second) {
  const std::string expected = expected_order_of(first, second);
  EXPECT_EQ(moments_in_order(first, second), expected) << first.hi << '+' << first.lo << '\n'
                                                       << second.hi << '+' << second.lo;
  const std::string back = expected == "before" ? "after" : expected == "after" ? "before" : expected;
  EXPECT_EQ(moments_in_order(second, first), back);
}

Moment known(double hi, double lo = 0) {
  return {hi, lo, std::nullopt, 1};
}

class MomentStrata : public testing::TestWithParam<strata::Stratum> {};

// A query and the double nearest to its moment, and that one nudged by as little as can be said in hi + lo:
// the order is that of the rounding error.
TEST_P(MomentStrata, BesideTheirRoundedTimes) {
  strata::Random random(7);
  int close = 0;
  for (const TimingQuery& query : GetParam().queries) {
    Counters counters;
    const std::optional<double> t = rounded_time(query, counters).t;
    if (!t || !std::isfinite(*t)) continue;
    const double start = std::ldexp(random.uniform(0, 2), random.integer(-30, 30));
    for (const int multiple : {1, 2}) {
      const double rounded = multiple * *t;
      if (!std::isfinite(start + rounded)) continue;
      const Moment moment{start, start * 0x1p-60, query, multiple};
      expect_moments(moment, known(start + rounded));
      expect_moments(moment, known(start + rounded, (start + rounded) * 0x1p-70));
      expect_moments({0, 0, query, multiple}, known(rounded));
      expect_moments({rounded, 0, query, multiple}, {0, 0, query, multiple});
      ++close;
    }
  }
  EXPECT_GT(close, 0) << "a stratum without events";
}

// Two queries whose starts put them as near together as doubles can.
TEST_P(MomentStrata, StartsThatMakeUpForTheTimes) {
  const std::vector<TimingQuery>& queries = GetParam().queries;
  for (std::size_t i = 0; i + 1 < queries.size(); ++i) {
    Counters counters;
    const std::optional<double> t1 = rounded_time(queries[i], counters).t;
    const std::optional<double> t2 = rounded_time(queries[i + 1], counters).t;
    const double start = 3;
    if (!t1 || !t2 || !std::isfinite(start + *t1 - *t2)) continue;
    expect_moments({start, 0, queries[i], 1}, {start + (*t1 - *t2), 0, queries[i + 1], 1});
  }
}

INSTANTIATE_TEST_SUITE_P(, MomentStrata, testing::ValuesIn(strata::all(20260104, 60)), strata::Name{});

TEST(MomentOrder, ExactTiesFromDifferentStarts) {
  const TimingQuery six = strata::relative(Kind::block, {-10, 3, 0}, {1, 0, 0}, 5);
  const TimingQuery five = strata::relative(Kind::block, {-10, 0, 0}, {1, 0, 0}, 5);
  EXPECT_EQ(moments_in_order({1, 0, six, 1}, {2, 0, five, 1}), "equal");
  EXPECT_EQ(moments_in_order({1, 0x1p-80, six, 1}, {2, 0, five, 1}), "after");
  EXPECT_EQ(moments_in_order({1, 0, six, 1}, {2, 0x1p-1074, five, 1}), "before");
  EXPECT_EQ(moments_in_order({1, 0, six, 1}, known(7)), "equal");
  EXPECT_EQ(moments_in_order({1, 0x1p-70, six, 1}, known(7, 0x1p-70)), "equal");
  EXPECT_EQ(moments_in_order({1, 0, six, 1}, known(7, -0x1p-900)), "after");
  const TimingQuery irrational = strata::relative(Kind::block, {-7, 1, 0}, {1, 0, 0}, 3);  // 7 − √8
  const TimingQuery longer = strata::relative(Kind::block, {-8, 0, 1}, {1, 0, 0}, 3);      // 8 − √8
  EXPECT_EQ(moments_in_order({1, 0, irrational, 1}, {0, 0, longer, 1}), "equal");
  EXPECT_EQ(moments_in_order({1, 0x1p-100, irrational, 1}, {0, 0, longer, 1}), "after");
}

TEST(MomentOrder, TwiceTheTimeOfAPairTakenToBeAtItsLimit) {
  const TimingQuery turning = strata::relative(Kind::tether, {-6, 8, 0}, {1, 0, 0}, 7);  // at 6
  EXPECT_EQ(moments_in_order({1, 0, turning, 2}, known(13)), "equal");
  EXPECT_EQ(moments_in_order({1, 0, turning, 2}, known(13, 0x1p-200)), "before");
  EXPECT_EQ(moments_in_order({1, 0, turning, 1}, known(7)), "equal");
}

TEST(MomentOrder, KnownTimesAndEventsAtOnce) {
  const TimingQuery contact = strata::relative(Kind::block, {1, 0, 0}, {-1, 0, 0}, 1);
  const TimingQuery miss = strata::relative(Kind::block, {-3, 2, 0}, {1, 0, 0}, 1);
  EXPECT_EQ(moments_in_order({4, 0, contact, 1}, known(4)), "equal");
  EXPECT_EQ(moments_in_order({4, 0, contact, 1}, known(4, 0x1p-60)), "before");
  EXPECT_EQ(moments_in_order(known(1, 0x1p-1074), known(1)), "after");
  EXPECT_EQ(moments_in_order(known(0x1p1000), {0, 0, miss, 1}), "before");
  EXPECT_EQ(moments_in_order({0, 0, miss, 1}, {9, 0, miss, 1}), "none");
}

TEST(MomentOrder, EveryStageIsReached) {
  strata::Random random(9);
  Counters apart;
  Counters near;
  Counters ties;
  for (int asked = 0; asked < 300;) {
    const TimingQuery query = strata::plain(random, Kind::tether);
    Counters counters;
    if (!(rounded_time(query, counters).t > 0.)) continue;  // those at once are settled by their starts
    ++asked;
    const double start = random.uniform(1, 100);
    moment_order(Moment{start, 0, query, 1}, Moment{start * (1 + 0x1p-30), 0, query, 1}, apart);
    moment_order(Moment{start, 0, query, 1}, Moment{start, start * 0x1p-60, query, 1}, near);
    moment_order(Moment{start, 0, query, 1}, Moment{start, 0, query, 1}, ties);
  }
  EXPECT_LT(apart.order.uncertain, 5U);
  EXPECT_GT(near.order.uncertain, 290U);
  EXPECT_LT(near.order.exact, 5U);
  EXPECT_GT(ties.order.exact, 290U);
  EXPECT_GT(ties.largest_bits, 100U);
}

}  // namespace
}  // namespace tps::exact
