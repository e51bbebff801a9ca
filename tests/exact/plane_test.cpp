// Planes against fractions: verdicts, rounded times, and their order beside times that are roots.
#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <map>
#include <random>

#include "verify/exact/rounded_time.hpp"
#include "verify/exact/time_order.hpp"

namespace tps::exact {
namespace {

using Rational = boost::multiprecision::cpp_rational;

struct Line {
  Rational gap, towards;  ///< n·r − L, −n·v
};

Line line_of(const TimingQuery& q) {
  Line line{-Rational(q.L), 0};
  for (std::size_t k = 0; k < 3; ++k) {
    line.gap += Rational(q.normal[k]) * (Rational(q.u_B[k]) - Rational(q.u_A[k]));
    line.towards -= Rational(q.normal[k]) * (Rational(q.v_B[k]) - Rational(q.v_A[k]));
  }
  return line;
}

/// Whether t is the double nearest to x, of two the even one: by the middles to both neighbours.
bool is_nearest(double t, const Rational& x) {
  const Rational below = (Rational(t) + Rational(std::nextafter(t, -1))) / 2;
  const Rational above = (Rational(t) + Rational(std::nextafter(t, HUGE_VAL))) / 2;
  int exponent = 0;
  const bool even = std::fmod(std::ldexp(std::frexp(t, &exponent), 53), 2) == 0;
  return even ? below <= x && x <= above : below < x && x < above;
}

/// Normals along an axis and leaning ones; now and then at the plane, along it, or one bit beside either.
TimingQuery random_query(std::mt19937_64& random) {
  const auto uniform = [&] { return std::uniform_real_distribution<double>(-4, 4)(random); };
  TimingQuery q{Kind::plane, {uniform(), uniform(), uniform()}, {uniform(), uniform(), uniform()},
                {},          {uniform(), uniform(), uniform()}, .5,
                {0, 1, 0}};
  if (random() % 2 == 0) q.normal = {.6, 0, -.8};
  if (random() % 4 == 0) q.v_A = {uniform(), uniform(), 0};
  if (random() % 4 == 0) {
    q.normal = {0, 1, 0};
    q.u_A[1] = std::ldexp(std::floor(std::ldexp(q.u_A[1], 20)), -20);
    q.u_B[1] = q.u_A[1] + .5;
    if (random() % 2 == 0) q.u_B[1] = std::nextafter(q.u_B[1], uniform() < 0 ? -9. : 9.);
  }
  if (random() % 8 == 0) {
    q.normal = {.6, 0, -.8};
    q.v_A = {};
    q.v_B = {4, 1, 3};  // .6 and .8 are not those fractions: n·v is a rounding
  }
  if (random() % 32 == 0) q.v_B = q.v_A;
  return q;
}

TEST(Planes, VerdictsAndTimesAreThoseOfFractions) {
  std::mt19937_64 random(11);
  std::map<Verdict, int> seen;
  Counters counters, slow;
  for (int n = 0; n < 5000; ++n) {
    const TimingQuery q = random_query(random);
    const TimingAnswer answer = rounded_time(q, counters);
    ++seen[answer.verdict];
    const Line line = line_of(q);
    const Verdict right = is_static(q)        ? Verdict::static_pair
                          : line.towards <= 0 ? Verdict::receding
                          : line.gap < 0      ? Verdict::overlap
                          : line.gap == 0     ? Verdict::contact
                                              : Verdict::hit;
    ASSERT_EQ(answer.verdict, right) << n;
    ASSERT_EQ(answer.t.has_value(), line.towards > 0 && !is_static(q));
    ASSERT_EQ(answer.t, rounded_time_by_integers(q, slow).t) << n;
    if (right == Verdict::hit) {
      ASSERT_TRUE(is_nearest(*answer.t, line.gap / line.towards)) << n;
    }
  }
  for (const Verdict verdict :
       {Verdict::static_pair, Verdict::receding, Verdict::overlap, Verdict::contact, Verdict::hit})
    EXPECT_GE(seen[verdict], 25) << name(verdict);
  EXPECT_GE(counters.verdict.exact, 250U);
  // An eighth of them starts an ulp beside the plane, where double words have no digits left.
  EXPECT_LE(counters.time.exact, counters.time.calls / 5);
}

// A plane's time is (x − L)/1, a pair's along the same axis (x − 1)/1: ties by construction, and one bit off.
TEST(Planes, OrderBesideRootsIsExact) {
  Counters counters;
  for (const double x : {3., 3.7, 5.0625, 0x1.123456789abcdp3}) {
    const TimingQuery plane{Kind::plane, {}, {x, 1, 2}, {}, {-1, 0, 0}, .5, {1, 0, 0}};
    TimingQuery pair{Kind::block, {-.5, 0, 0}, {x, 0, 0}, {}, {-1, 0, 0}, 1};
    EXPECT_EQ(time_order(plane, pair, counters), Order::equal) << x;
    pair.u_B[0] = std::nextafter(x, 9);
    EXPECT_EQ(time_order(plane, pair, counters), Order::before) << x;
    EXPECT_EQ(time_order(pair, plane, counters), Order::after) << x;
    pair.u_B[0] = std::nextafter(x, 0);
    EXPECT_EQ(time_order(plane, pair, counters), Order::after) << x;
    const Moment known{x - .5, 0, std::nullopt, 1};
    EXPECT_EQ(moment_order(Moment{0, 0, plane, 1}, known, counters), Order::equal) << x;
  }
  EXPECT_GE(counters.order.exact, 8U);
}

// The root of a pair that is not rational never ties with a plane: √2 against its neighbours in double.
TEST(Planes, AnIrrationalRootIsBetweenItsNeighbours) {
  Counters counters;
  const TimingQuery pair{Kind::tether, {}, {1, 1, 0}, {}, {-1, 1, 0}, 2};  // |(1 − t, 1 + t)| = 2 at t = 1
  TimingQuery root = pair;
  root.L = 3;  // 2 + 2t² = 9: t = √3.5
  const double t = std::sqrt(3.5);
  for (const double other : {std::nextafter(t, 0), t, std::nextafter(t, 9)}) {
    const TimingQuery plane{Kind::plane, {}, {other + 1, 0, 0}, {}, {-1, 0, 0}, 1, {1, 0, 0}};
    const bool exact = other + 1 - 1 == other;
    if (!exact) continue;
    const Order expected = Rational(other) * Rational(other) < Rational(3.5) ? Order::before : Order::after;
    EXPECT_EQ(time_order(plane, root, counters), expected) << other;
  }
  const TimingQuery at_one{Kind::plane, {}, {2, 0, 0}, {}, {-1, 0, 0}, 1, {1, 0, 0}};
  EXPECT_EQ(time_order(at_one, pair, counters), Order::equal);
}

}  // namespace
}  // namespace tps::exact
