// Exact order against 1500 digits: pairs of every stratum, exact ties and their nearest neighbours.
#include "verify/exact/time_order.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/exact/referee.hpp"
#include "verify/exact/exact_order.hpp"
#include "verify/exact/rounded_time.hpp"
#include "verify/vectors/timing_strata.hpp"

namespace tps::exact {
namespace {

using referee::Wide;

/// Agreement to 480 digits counts as a tie: algebraic numbers of these sizes differ earlier or not at all.
std::string expected_order(const TimingQuery& first, const TimingQuery& second) {
  static const Wide unit = pow(Wide(10), -480);
  const std::optional<Wide> t1 = referee::time(first);
  const std::optional<Wide> t2 = referee::time(second);
  if (!t1 && !t2) return "none";
  if (!t1 || !t2) return t1 ? "before" : "after";
  if (abs(*t1 - *t2) <= unit * *t1) return "equal";
  return *t1 < *t2 ? "before" : "after";
}

std::string order(const TimingQuery& first, const TimingQuery& second) {
  Counters counters;
  return std::string(name(time_order(first, second, counters)));
}

std::string reversed(const std::string& order) {
  return order == "before" ? "after" : order == "after" ? "before" : order;
}

void expect_order(const TimingQuery& first, const TimingQuery& second) {
  const std::string expected = expected_order(first, second);
  EXPECT_EQ(order(first, second), expected) << strata::text(first) << "\n" << strata::text(second);
  EXPECT_EQ(order(second, first), reversed(expected));
}

class OrderStrata : public testing::TestWithParam<strata::Stratum> {};

TEST_P(OrderStrata, NeighboursInTheListAndEachWithItself) {
  const std::vector<TimingQuery>& queries = GetParam().queries;
  for (std::size_t i = 0; i + 1 < queries.size(); ++i) {
    expect_order(queries[i], queries[i + 1]);
    expect_order(queries[i], queries[i]);
  }
}

/// The largest velocity component: one bit of it changes a time by more than the referee's 480 digits miss.
double& fastest_component(TimingQuery& query) {
  double* fastest = &query.v_A[0];
  for (Vec3* v : {&query.v_A, &query.v_B}) {
    for (double& component : *v) {
      if (std::fabs(component) > std::fabs(*fastest)) fastest = &component;
    }
  }
  return *fastest;
}

// With the axes exchanged it is the same time from other sums; with one bit changed it is next to a tie.
TEST_P(OrderStrata, TheSameTimeInOtherNumbers) {
  for (const TimingQuery& query : GetParam().queries) {
    TimingQuery other = query;
    for (Vec3* x : {&other.u_A, &other.u_B, &other.v_A, &other.v_B}) *x = {-(*x)[2], (*x)[0], -(*x)[1]};
    const std::string same = order(query, query);
    EXPECT_EQ(order(query, other), same);
    double& fastest = fastest_component(other);
    fastest = std::nextafter(fastest, 0.0);
    expect_order(query, other);
  }
}

INSTANTIATE_TEST_SUITE_P(, OrderStrata, testing::ValuesIn(strata::all(20260103, 100)), strata::Name{});

TEST(TimeOrder, ExactTieAndItsNeighbours) {
  const TimingQuery first = strata::relative(Kind::block, {-10, 3, 0}, {1, 0, 0}, 5);
  EXPECT_EQ(order(first, strata::relative(Kind::block, {-11, 0, 0}, {1, 0, 0}, 5)), "equal");
  EXPECT_EQ(order(first, strata::relative(Kind::block, {-11 - 0x1p-40, 0, 0}, {1, 0, 0}, 5)), "before");
  EXPECT_EQ(order(first, strata::relative(Kind::block, {-11 + 0x1p-40, 0, 0}, {1, 0, 0}, 5)), "after");
  EXPECT_EQ(order(first, strata::relative(Kind::tether, {-1, 0, 0}, {1, 0, 0}, 5)), "equal");
  EXPECT_EQ(order(first, strata::relative(Kind::tether, {-6, 8, 0}, {1, 0, 0}, 7)), "equal");  // turning at 6
}

TEST(TimeOrder, EventsAtOnceAndNoEvents) {
  const TimingQuery contact = strata::relative(Kind::block, {1, 0, 0}, {-1, 0, 0}, 1);
  const TimingQuery taut = strata::relative(Kind::tether, {1, 0, 0}, {0, 1, 0}, 1);
  const TimingQuery miss = strata::relative(Kind::block, {-3, 2, 0}, {1, 0, 0}, 1);
  const TimingQuery soon = strata::relative(Kind::block, {0x1p-1000, 0, 0}, {-0x1p1000, 0, 0}, 0x1p-1001);
  EXPECT_EQ(order(contact, taut), "equal");
  EXPECT_EQ(order(contact, soon), "before");
  EXPECT_EQ(order(contact, miss), "before");
  EXPECT_EQ(order(miss, soon), "after");
  EXPECT_EQ(order(miss, miss), "none");
}

// √2-like ties: roots of quadratics with different discriminants that are equal, and one that is not by
// 2^-1000.
TEST(TimeOrder, IrrationalTies) {
  const TimingQuery one = strata::relative(Kind::block, {-7, 1, 0}, {1, 0, 0}, 3);  // 7 − √8
  EXPECT_EQ(order(one, strata::relative(Kind::block, {-21, 3, 0}, {3, 0, 0}, 9)), "equal");
  EXPECT_EQ(order(one, strata::relative(Kind::block, {-7, 0, 2}, {1, 0, 0}, 3)), "before");
  const TimingQuery nearly = strata::relative(Kind::block, {-14, 14, 0}, {2, 0, 0}, std::sqrt(228.0));
  EXPECT_NE(order(one, nearly), "equal");
  expect_order(one, nearly);
  EXPECT_EQ(order(one, strata::relative(Kind::block, {-7, 1, 0x1p-500}, {1, 0, 0}, 3)), "before");
}

// sign(X + Y√A + Z√B) against every small case, computed in 1500 digits.
TEST(TimeOrder, NestedSquarings) {
  int zeros = 0;
  for (int X = -4; X <= 4; ++X) {
    for (int Y = -2; Y <= 2; ++Y) {
      for (int Z = -2; Z <= 2; ++Z) {
        for (int A = 0; A <= 9; ++A) {
          for (int B = 0; B <= 9; ++B) {
            const double value = X + Y * std::sqrt(A) + Z * std::sqrt(B);
            // Small integers: a sum that is not zero is larger than 1e-3.
            const Sign expected = std::fabs(value) < 1e-9 ? Sign::zero
                                  : value < 0             ? Sign::negative
                                                          : Sign::positive;
            if (expected == Sign::zero) ++zeros;
            ASSERT_EQ(sign_of_sum(X, Y, A, Z, B), expected) << X << Y << A << Z << B;
          }
        }
      }
    }
  }
  EXPECT_GT(zeros, 500);
}

TEST(TimeOrder, EveryStageIsReached) {
  strata::Random random(9);
  Counters far_apart;
  Counters close;
  Counters ties;
  for (int i = 0; i < 500; ++i) {
    const TimingQuery query = strata::plain(random, Kind::tether);
    time_order(query, strata::plain(random, Kind::tether), far_apart);
    TimingQuery nudged = query;
    nudged.v_B[0] = std::nextafter(query.v_B[0], 9);
    time_order(query, nudged, close);
    time_order(query, query, ties);
  }
  EXPECT_LT(far_apart.order.uncertain, 5U);
  EXPECT_GT(close.order.uncertain, 200U);
  EXPECT_EQ(close.order.exact, 0U);
  EXPECT_GT(ties.order.exact, 200U);
}

// Order and rounded times tell one story.
TEST(TimeOrder, RoundedTimesDoNotDecrease) {
  strata::Random random(10);
  for (int i = 0; i < 2000; ++i) {
    const TimingQuery first = strata::plain(random, Kind::tether);
    const TimingQuery second = strata::plain(random, Kind::block);
    Counters counters;
    if (time_order(first, second, counters) != Order::before) continue;
    const std::optional<double> t2 = rounded_time(second, counters).t;
    if (t2) {
      EXPECT_LE(*rounded_time(first, counters).t, *t2);
    }
  }
}

}  // namespace
}  // namespace tps::exact
