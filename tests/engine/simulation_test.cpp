// What the loop promises beside its results: what is predicted again, how time is kept, what is not there.
#include "reference/engine/simulation.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <random>

#include "reference/engine/group_coupling.hpp"
#include "reference/run/explain.hpp"
#include "verify/scenes/gas.hpp"
#include "verify/scenes/three_body.hpp"

namespace tps {
namespace {

using Rational = boost::multiprecision::cpp_rational;

Rational exact(const Time<double>& t) {
  return Rational(t.hi) + Rational(t.lo);
}

TEST(Clock, AddsWithoutLosingSmallSteps) {
  Time<double> t{0x1p+40, 0};
  const double dt = 0x1.8p-30;  // far below the ulp of 2^40
  for (int n = 0; n < 1000; ++n) t = after(t, dt);
  EXPECT_EQ(exact(t), Rational(0x1p+40) + 1000 * Rational(dt));
  EXPECT_EQ(elapsed({0x1p+40, 0}, t), 1000 * dt);
}

TEST(Clock, ElapsedIsTheRoundedDifference) {
  Time<double> t{.1, 0};
  for (int n = 1; n < 2000; ++n) {
    const Time<double> next = after(t, 1. / (double(n) * n * n));
    for (const Time<double>& early : {Time<double>{}, Time<double>{.1, 0}, t}) {
      EXPECT_EQ(elapsed(early, next), (exact(next) - exact(early)).convert_to<double>());
    }
    t = next;
  }
}

// With two roundings, as it once was, 1300 of these were the number beside the nearest.
template <typename Scalar>
void expect_nearest() {
  constexpr int digits = std::numeric_limits<Scalar>::digits;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0, 1);
  const auto some_time = [&](int n) {
    const Scalar hi = static_cast<Scalar>(std::ldexp(uniform(random), n % 21 - 10));
    const double part = n % 3 == 0 ? std::round(8 * uniform(random)) / 8 : uniform(random) - .5;
    return normalised<Scalar>(hi, static_cast<Scalar>(std::ldexp(part, -digits)) * hi);
  };
  for (int n = 0; n < 100000; ++n) {
    Time<Scalar> early = some_time(n);
    Time<Scalar> late = n % 4 == 0 ? normalised<Scalar>(early.hi, some_time(n).lo) : some_time(n / 7);
    if (late < early) std::swap(early, late);
    const Dyadic difference = (dyadic(late.hi) - dyadic(early.hi)) + (dyadic(late.lo) - dyadic(early.lo));
    ASSERT_EQ(elapsed(early, late), nearest<Scalar>(difference)) << n;
  }
}

TEST(Clock, ElapsedIsTheNearestNumber) {
  expect_nearest<float>();
  expect_nearest<double>();
  expect_nearest<long double>();
}

// The measure of "nearest" itself, against the hardware.
TEST(Clock, NearestRoundsAsTheHardwareDoes) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int n = 0; n < 20000; ++n) {
    double x = std::ldexp(uniform(random), n % 200 - 100);
    if (n % 2 == 0) x = static_cast<double>(static_cast<float>(x)) * (1 + 0x1p-24);  // half-way
    ASSERT_EQ(nearest<float>(dyadic(x)), static_cast<float>(x));
  }
}

// Found in quad: a collapsed run whose clock toggled between two spellings of one time was not seen to stand
// still.
TEST(Clock, HasOneSpellingForATime) {
  using Quad = boost::multiprecision::cpp_bin_float_quad;
  const Quad ulp = std::numeric_limits<Quad>::epsilon();
  const Quad h = Quad(1) + 3 * ulp;
  for (int n = -999; n < 1000; ++n) {
    const Time<Quad> t = after({h, Quad(0)}, Quad(ulp * n / 1000));
    EXPECT_EQ(after(t, Quad(0)), t) << n;
    EXPECT_LE(abs(t.lo), ulp / 2) << n;                                      // hi is the nearest
    EXPECT_LE(abs(Quad(t.hi - h) + t.lo - ulp * n / 1000), ulp * ulp) << n;  // the error that after() states
  }
}

TEST(Simulation, AnEventPredictsItsOwnParticlesAgainAndNoOther) {
  const Scene scene = build_gas({.particles = 40, .density = .3, .restitution = .9, .duration = 100});
  Simulation<double, 3> simulation(scene);
  std::vector<int> involved;
  simulation.world().sink = [&](const Record<double, 3>& record) {
    involved.clear();
    for (const auto& change : record.involved) involved.push_back(change.particle);
  };
  int wall_hits = 0;
  for (int n = 0; n < 300; ++n) {
    std::vector<std::uint32_t> before;
    for (int i = 0; i < simulation.world().size(); ++i) before.push_back(simulation.world().revision(i));
    simulation.step();
    int changed = 0;
    for (int i = 0; i < simulation.world().size(); ++i) {
      const std::size_t at = static_cast<std::size_t>(i);
      const bool moved = before[at] != simulation.world().revision(i);
      const bool named = std::find(involved.begin(), involved.end(), i) != involved.end();
      EXPECT_EQ(moved, named && !simulation.world().fixed(i));
      changed += moved ? 1 : 0;
    }
    const bool wall = simulation.world().fixed(involved.at(0)) || simulation.world().fixed(involved.at(1));
    EXPECT_EQ(changed, wall ? 1 : 2);
    wall_hits += wall ? 1 : 0;
  }
  EXPECT_GT(wall_hits, 20);
}

TEST(Simulation, WhatASceneDoesNotCallForIsNotThere) {
  const Scene plain = build_three_body({});
  Simulation<double, 2> simulation(plain);
  ASSERT_EQ(simulation.effects().size(), 1U);
  EXPECT_EQ(simulation.effects()[0]->name(), "rebound");
  EXPECT_NE((dynamic_cast<FreeCoupling<double, 2>*>(simulation.world().coupling.get())), nullptr);
  const Scene grouped = build_three_body({.grouped = .1});
  Simulation<double, 2> with_groups(grouped);
  EXPECT_EQ(with_groups.effects().size(), 2U);
  EXPECT_NE((dynamic_cast<GroupCoupling<double, 2>*>(with_groups.world().coupling.get())), nullptr);
  for (const EffectCall& call : explain(plain).effects) {
    EXPECT_EQ(call.because.empty(), call.name != "rebound") << call.name;
  }
}

TEST(Simulation, TheNextEventIsNeverBeforeTheLast) {
  const Scene scene = build_gas({.particles = 60, .density = .5, .duration = 100});
  Simulation<double, 3> simulation(scene);
  for (int n = 0; n < 500; ++n) {
    const Time<double> next = simulation.next_time();
    EXPECT_LE(simulation.world().now, next);
    simulation.step();
    EXPECT_EQ(simulation.world().now, next);
  }
}

TEST(Responded, DoesNotDependOnEntriesThatAPartnerVoided) {
  Responded seldom_cleared({false, false, false});
  seldom_cleared.add(0, 2, Limit::inner);
  seldom_cleared.forget(2);  // 0 keeps half of the pair
  EXPECT_FALSE(seldom_cleared.contains(0, 2, Limit::inner));
  seldom_cleared.add(0, 1, Limit::inner);
  seldom_cleared.add(0, 2, Limit::inner);
  Responded fresh({false, false, false});
  fresh.add(0, 1, Limit::inner);
  fresh.add(0, 2, Limit::inner);
  EXPECT_EQ(seldom_cleared.of(0), fresh.of(0));
}

}  // namespace
}  // namespace tps
