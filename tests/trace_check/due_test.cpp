// The interval in which an event is due holds what the reference computes, and is not much wider.
#include "verify/trace_check/due.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <random>

#include "reference/equations/eq2_collision_time.hpp"
#include "reference/equations/eq2_paper_time.hpp"
#include "verify/trace_check/number.hpp"

namespace tps::check {
namespace {

using Vector3 = Vector<double, 3>;

struct Pair {
  Vector3 r, v;
  double L = 1;
};

Vector3 direction(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  const double x = normal(random);
  const double y = normal(random);
  const double z = normal(random);
  return Vector3(x, y, z).normalized();
}

/// Aimed at the edges: grazes from near and far, touches, taut pairs, a few ulps to either side.
Pair aimed_pair(std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  std::uniform_int_distribution<int> ulps(-4, 4);
  std::uniform_int_distribution<int> aim(0, 4);
  Pair pair;
  const Vector3 n = direction(random);
  const Vector3 w = n.cross(direction(random)).normalized();
  const double near_L = 1 + ulps(random) * 0x1p-52;
  const double far = std::exp(8 * unit(random));
  const double speed = std::exp(6 * unit(random) - 3);
  switch (aim(random)) {
    case 0:  // general
      pair.r = (2 * unit(random)) * n;
      pair.v = speed * direction(random);
      break;
    case 1:  // graze from afar
      pair.r = near_L * w - far * n;
      pair.v = speed * n;
      break;
    case 2:  // at the limit, any way
      pair.r = near_L * n;
      pair.v = speed * direction(random);
      break;
    case 3:  // at the limit, across
      pair.r = near_L * n;
      pair.v = speed * w + (ulps(random) * 0x1p-53) * n;
      break;
    default:  // shallow chord
      pair.r = (1 - std::exp(-30 * unit(random))) * w - 0.1 * unit(random) * n;
      pair.v = speed * n;
  }
  return pair;
}

Due<long double> due_of(const Pair& p, bool outer, Timing timing) {
  RelativeFlight<long double> flight;
  for (int k = 0; k < 3; ++k) {
    flight.r[static_cast<std::size_t>(k)] = p.r[k];
    flight.v[static_cast<std::size_t>(k)] = p.v[k];
  }
  const auto q = quadratic_of<long double>(flight, p.L, 0x1p-53L, timing, 1);
  return due(q, LimitAsked<long double>{outer, p.L, false});
}

/// How many of the answers lie in the narrower of two intervals around them, and that none lies outside.
struct Tally {
  int answers = 0, none = 0, outside = 0, open = 0;
};

template <typename Answer>
Tally tally_of(bool outer, Timing timing, Answer answer) {
  std::mt19937_64 random(7);
  Tally tally;
  const Vector3 zero = Vector3::Zero();
  for (int n = 0; n < 200'000; ++n) {
    const Pair p = aimed_pair(random);
    const Due<long double> due = due_of(p, outer, timing);
    const CollisionTime<double> found = answer(zero, p.r, zero, p.v, p.L);
    if (due.can_be_none && !due.must_be_none) ++tally.open;
    if (!found.t) {
      ++tally.none;
      if (!due.can_be_none) ++tally.outside;
      continue;
    }
    ++tally.answers;
    if (due.must_be_none || *found.t < due.earliest || *found.t > due.latest) ++tally.outside;
  }
  return tally;
}

TEST(Due, HoldsTheStableBlockingTimes) {
  const Tally tally = tally_of(false, Timing::stable, block_time<double, 3>);
  EXPECT_EQ(tally.outside, 0);
  EXPECT_GT(tally.answers, 50'000);
  EXPECT_GT(tally.none, 50'000);
}

TEST(Due, HoldsTheStableTetheringTimes) {
  const Tally tally = tally_of(true, Timing::stable, tether_time<double, 3>);
  EXPECT_EQ(tally.outside, 0);
  EXPECT_GT(tally.answers, 150'000);
}

TEST(Due, HoldsThePrintedBlockingTimes) {
  EXPECT_EQ(tally_of(false, Timing::paper, paper_block_time<double, 3>).outside, 0);
}

TEST(Due, HoldsThePrintedTetheringTimes) {
  EXPECT_EQ(tally_of(true, Timing::paper, paper_tether_time<double, 3>).outside, 0);
}

// The printed formulas need their wider interval: in that of the stable ones many of their answers are wrong.
TEST(Due, ThePrintedTimesAreOutsideTheStableInterval) {
  EXPECT_GT(tally_of(false, Timing::stable, paper_block_time<double, 3>).outside, 1000);
}

// A pair that approaches head-on has an interval of 57u to both sides: of Q 16 by c and 16 by D, of h 9, of
// t 16.
TEST(Due, IsNarrowWhereThePairDoesNotGraze) {
  const Pair pair{Vector3(3, 0, 0), Vector3(-1, 0, 0), 1};
  const Due<long double> due = due_of(pair, false, Timing::stable);
  EXPECT_LT(due.earliest, 2);
  EXPECT_GT(due.latest, 2);
  EXPECT_LT(due.latest - due.earliest, 115 * 0x1p-53L);
  EXPECT_FALSE(due.can_be_none);
}

// After a pull only the way through the inside counts; one that has been left outside turns back at −2h/a.
TEST(Due, APulledPairComesBackThroughTheInside) {
  RelativeFlight<long double> flight;
  flight.r = {{1.0L + 1e-15L, 0, 0}};
  flight.v = {{-1e-9L, 1, 0}};
  const auto q = quadratic_of<long double>(flight, 1, 0x1p-53L, Timing::stable, 1);
  const Due<long double> asked = due(q, LimitAsked<long double>{true, 1, true});
  EXPECT_FALSE(asked.can_be_none);
  EXPECT_GE(asked.latest, 2e-9L);
  const Due<long double> separating = [&] {
    flight.v = {{1, 0, 0}};
    return due(quadratic_of<long double>(flight, 1, 0x1p-53L, Timing::stable, 1),
               LimitAsked<long double>{true, 1, true});
  }();
  EXPECT_TRUE(separating.can_be_none);
  EXPECT_FALSE(separating.must_be_none);
  EXPECT_EQ(separating.earliest, 0);
  EXPECT_LT(separating.latest, 100 * 0x1p-53L);
}

}  // namespace
}  // namespace tps::check
