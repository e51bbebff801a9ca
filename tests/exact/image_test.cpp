// Images in a periodic box: filters and fast times against integers, and against the same question with the
// difference written out, where that is exact.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

#include "verify/exact/rounded_time.hpp"
#include "verify/exact/time_order.hpp"

namespace tps::exact {
namespace {

/// A pair whose difference is mostly the box: far coordinates, near images; now and then grazing or touching.
TimingQuery random_image(std::mt19937_64& random) {
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  TimingQuery q{random() % 2 == 0 ? Kind::block : Kind::tether, {}, {}, {}, {}, 1};
  q.edges = {5.3, 4.1, 0};
  q.v_A = {uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)};
  q.v_B = {uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)};
  for (std::size_t k = 0; k < 2; ++k) q.image[k] = std::floor(uniform(-1e6, 1e6));
  const double angle = uniform(0, 6.28), distance = random() % 4 == 0 ? 1 : uniform(.2, 2.5);
  const Vec3 r{distance * std::cos(angle), distance * std::sin(angle),
               random() % 2 == 0 ? 0 : uniform(-.5, .5)};
  for (std::size_t k = 0; k < 3; ++k) {
    q.u_A[k] = uniform(-9, 9);
    q.u_B[k] = q.u_A[k] + r[k] - q.image[k] * q.edges[k];
  }
  if (random() % 8 == 0) {  // aimed to pass at the distance 1
    q.v_A = {};
    q.v_B = {-r[0] - r[1] / 2, -r[1] + r[0] / 2, 0};
  }
  return q;
}

TEST(Images, FastAnswersAreThoseOfIntegers) {
  std::mt19937_64 random(5);
  std::map<Verdict, int> seen;
  Counters counters, slow;
  for (int n = 0; n < 4000; ++n) {
    const TimingQuery q = random_image(random);
    const TimingAnswer fast = rounded_time(q, counters);
    const TimingAnswer exact = rounded_time_by_integers(q, slow);
    ASSERT_EQ(fast.verdict, exact.verdict) << n;
    ASSERT_EQ(fast.t, exact.t) << n;
    ++seen[fast.verdict];
  }
  EXPECT_GE(seen[Verdict::hit], 500);
  EXPECT_GE(seen[Verdict::miss], 100);
  EXPECT_LE(counters.time.exact, counters.time.calls / 10);
}

// Dyadic edges and places: the shift can be written out, and nothing may change.
TEST(Images, AnExactShiftIsTheSameQuestion) {
  std::mt19937_64 random(6);
  Counters counters;
  for (int n = 0; n < 2000; ++n) {
    TimingQuery q = random_image(random);
    for (std::size_t k = 0; k < 3; ++k) {
      q.image[k] = std::floor(q.image[k] / 4096);
      q.edges[k] = k < 2 ? 5.25 : 0;
      q.u_A[k] = std::ldexp(std::floor(std::ldexp(q.u_A[k], 20)), -20);
      q.u_B[k] = q.u_A[k] +
                 std::ldexp(std::floor(std::uniform_real_distribution<double>(-2e6, 2e6)(random)), -20) -
                 q.image[k] * q.edges[k];
    }
    TimingQuery written = q;
    for (std::size_t k = 0; k < 3; ++k) written.u_B[k] += q.image[k] * q.edges[k];
    written.image = {};
    const TimingAnswer a = rounded_time(q, counters), b = rounded_time(written, counters);
    ASSERT_EQ(a.verdict, b.verdict) << n;
    ASSERT_EQ(a.t, b.t) << n;
    ASSERT_EQ(time_order(q, written, counters), a.t ? Order::equal : Order::none) << n;
  }
}

}  // namespace
}  // namespace tps::exact
