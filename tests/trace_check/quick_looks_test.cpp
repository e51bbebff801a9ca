// Looks in doubles that spare questions: pairs that flew apart, pairs that stay within an outer limit for a
// while; and the order in which anchors expire.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <random>

#include "verify/trace_check/expiries.hpp"
#include "verify/trace_check/quiet.hpp"

namespace tps::check {
namespace {

using Random = std::mt19937_64;

double uniform(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

Vec<double> somewhere(Random& random, double size) {
  return {{uniform(random, -size, size), uniform(random, -size, size), uniform(random, -size, size)}};
}

/// In units of 2^length and 2^speed.
FlightInDoubles flight(Random& random, double size, int length, int speed) {
  Vec<double> position = somewhere(random, size), velocity = somewhere(random, 1);
  for (std::size_t k = 0; k < 3; ++k) {
    position[k] = std::ldexp(position[k], length);
    velocity[k] = std::ldexp(velocity[k], speed);
  }
  return in_doubles(position, velocity, {std::ldexp(uniform(random, 0, 1), length - speed), 0});
}

/// r and v at the later of the two clocks, and r·v.
struct Relative {
  Vec<long double> r, v;
  long double rv() const { return dot(r, v); }
};

Relative relative(const FlightInDoubles& a, const FlightInDoubles& b) {
  const long double start = std::max(a.since.hi, b.since.hi);
  Relative result;
  for (std::size_t k = 0; k < 3; ++k) {
    result.r[k] = (b.position[k] + b.velocity[k] * (start - b.since.hi)) -
                  (a.position[k] + a.velocity[k] * (start - a.since.hi));
    result.v[k] = static_cast<long double>(b.velocity[k]) - a.velocity[k];
  }
  return result;
}

TEST(FlewApart, IsNeverSaidOfPairsThatApproachedFirst) {
  Random random(31);
  int apart = 0, said = 0;
  for (int n = 0; n < 100'000; ++n) {
    const bool plain = n % 4 == 0;
    const int length = plain ? 0 : std::uniform_int_distribution<int>(-1060, 1000)(random);
    const int speed = plain ? 0 : std::uniform_int_distribution<int>(-1060, 1000)(random);
    if (std::abs(length - speed) > 1000) continue;
    const FlightInDoubles a = flight(random, 1, length, speed), b = flight(random, 1, length, speed);
    const Instant<double> until{std::ldexp(2, length - speed), 0};
    const bool says = FirstLook(a.until(until, 0), 0, 0x1p-40).flew_apart(b.until(until, 0));
    const long double rv = relative(a, b).rv();
    EXPECT_TRUE(!says || rv > 0) << length << ' ' << speed;
    if (!plain || !(rv > std::ldexp(1e-6L, length + speed))) continue;
    ++apart;
    if (says) ++said;
  }
  EXPECT_GT(apart, 10'000);
  EXPECT_EQ(said, apart);
}

TEST(FlewApart, IsNotSaidWithinRounding) {
  const FlightInDoubles a = in_doubles<double>({{0, 0, 0}}, {{0, 0, 0}}, {});
  for (const double along : {-0x1p-41, 0.0, 0x1p-41}) {
    const FlightInDoubles b = in_doubles<double>({{1, 0, 0}}, {{along, 0, 0}}, {}, 0x1p-46);
    EXPECT_FALSE(FirstLook(a.until({1, 0}, 0), 0, 0x1p-40).flew_apart(b.until({1, 0}, 0)));
  }
  const FlightInDoubles uncertain = in_doubles<double>({{1, 0, 0}}, {{1, 0, 0}}, {}, 0x1p-44);
  EXPECT_FALSE(FirstLook(a.until({1, 0}, 0), 0, 0x1p-40).flew_apart(uncertain.until({1, 0}, 0)));
}

// Of a limit alone both ways to look say the same.
TEST(IsClearOfInner, IsIsClear) {
  Random random(32);
  int clear = 0, other = 0;
  for (int n = 0; n < 100'000; ++n) {
    const FlightInDoubles a = flight(random, 2, 0, 0), b = flight(random, 2, 0, 0);
    const FirstLook look(a.until({1.5, 0}, 0), 0, 0x1p-40);
    const bool of_inner = look.is_clear_of_inner(b.until({1.5, 0}, 0), 1);
    EXPECT_EQ(of_inner, look.is_clear(b.until({1.5, 0}, 0), {1, -1}));
    ++(of_inner ? clear : other);
  }
  EXPECT_GT(clear, 10'000);
  EXPECT_GT(other, 5'000);
}

TEST(TimeWithin, IsThatOfTheLimitToAHundredth) {
  Random random(33);
  int known = 0;
  for (int n = 0; n < 100'000; ++n) {
    const bool plain = n % 4 == 0;
    const int length = plain ? 0 : std::uniform_int_distribution<int>(-300, 300)(random);
    const int speed = plain ? 0 : std::uniform_int_distribution<int>(-300, 300)(random);
    const FlightInDoubles a = flight(random, 1, length, speed), b = flight(random, 1, length, speed);
    const double outer = std::ldexp(uniform(random, 0, 4), length);
    const double share = n % 3 == 0 ? 0x1p-11 : 0x1p-40;
    const std::optional<double> within = time_within(a, b, outer, share);
    if (!within) continue;
    const Relative x = relative(a, b);
    const long double vv = dot(x.v, x.v), left = static_cast<long double>(outer) * outer - dot(x.r, x.r);
    const long double root = (std::sqrt(x.rv() * x.rv() + vv * left) - x.rv()) / vv;
    EXPECT_GT(left, 0);
    EXPECT_NEAR(static_cast<double>(*within / root), 1, .01);
    if (plain) ++known;
  }
  EXPECT_GT(known, 5'000);
}

TEST(TimeWithin, IsNotKnownAtTheLimitOrAtRest) {
  const FlightInDoubles a = in_doubles<double>({{0, 0, 0}}, {{0, 0, 0}}, {});
  const auto within = [&](double place, double speed, double share, bool is_certain = true) {
    const FlightInDoubles b = in_doubles<double>({{place, 0, 0}}, {{speed, 0, 0}}, {}, is_certain ? 0 : 1);
    return time_within(a, b, 2, share).has_value();
  };
  EXPECT_TRUE(within(1, 1, 0x1p-40));
  EXPECT_FALSE(within(2, 1, 0x1p-40));
  EXPECT_FALSE(within(2 - 0x1p-36, 1, 0x1p-40));
  EXPECT_FALSE(within(3, -1, 0x1p-40));
  EXPECT_FALSE(within(1, 0, 0x1p-40));
  EXPECT_FALSE(within(1.95, 1, 0x1p-11));
  EXPECT_FALSE(within(1, 1, 0x1p-40, false));
}

using Expiry = Expiries::Expiry;
using OneHeap = std::priority_queue<Expiry, std::vector<Expiry>, std::greater<>>;

/// Takes out whatever is due by t of both, which has to be the same.
int take_until(Expiries& expiries, OneHeap& heap, double t) {
  int taken = 0;
  while (const Expiry* const next = expiries.next(t)) {
    EXPECT_FALSE(heap.empty());
    if (heap.empty()) return taken;
    EXPECT_EQ(next->t, heap.top().t);
    EXPECT_EQ(next->particle, heap.top().particle);
    EXPECT_EQ(next->number, heap.top().number);
    EXPECT_EQ(expiries.probably_next(t), next);
    expiries.pop();
    heap.pop();
    ++taken;
  }
  EXPECT_TRUE(heap.empty() || heap.top().t > t);
  return taken;
}

TEST(Expiries, ComeAsOfOneHeap) {
  Random random(34);
  Expiries expiries;
  OneHeap heap;
  double now = 0;
  int taken = 0;
  for (int n = 0; n < 20'000; ++n) {
    const bool ties = n % 5 == 0;
    const double wait = ties ? .5 : std::exp(uniform(random, -8, 3));
    const Expiry expiry{n % 1000 == 7 ? now - 1 : now + wait, n % 100, static_cast<std::uint32_t>(n)};
    expiries.push(expiry);
    heap.push(expiry);
    EXPECT_EQ(expiries.size(), heap.size());
    if (n % 3 != 0) continue;
    now += n % 4000 < 2000 ? .001 : .05;
    taken += take_until(expiries, heap, now);
  }
  EXPECT_GT(taken, 5'000);
  EXPECT_EQ(take_until(expiries, heap, HUGE_VAL) + taken, 20'000);
  EXPECT_EQ(expiries.next(HUGE_VAL), nullptr);
}

TEST(Expiries, GoOnWithOthers) {
  Expiries expiries;
  OneHeap heap;
  for (int n = 0; n < 100; ++n) expiries.push({static_cast<double>(n), n, 0});
  ASSERT_NE(expiries.next(5), nullptr);
  std::vector<Expiry> others;
  for (int n = 0; n < 50; ++n) {
    others.push_back({50.0 - n, n, 1});
    heap.push(others.back());
  }
  expiries.assign(others);
  EXPECT_EQ(expiries.size(), 50U);
  EXPECT_EQ(take_until(expiries, heap, 20), 20);
  EXPECT_EQ(take_until(expiries, heap, 50), 30);
}

}  // namespace
}  // namespace tps::check
