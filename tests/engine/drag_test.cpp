// Drag against closed forms: paths, stopping distances, what never happens, the energy that it takes; and
// against the run of the same scene without it.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>

#include "reference/engine/drag_clock.hpp"
#include "tests/run/resumed_run.hpp"
#include "tests/run/traced_run.hpp"

namespace tps {
namespace drag_test {
namespace {

using testing::add_particle;

constexpr double kForEver = std::numeric_limits<double>::infinity();

Scene dragged(double gamma, double duration) {
  Scene scene = testing::plain_scene();
  scene.drag = Drag{gamma};
  scene.duration = duration;
  return scene;
}

/// Balls that collide, form tethers and break them, in a container.
Scene busy(std::optional<Drag> drag) {
  Scene scene = testing::plain_scene(3);
  scene.drag = drag;
  scene.duration = 30;
  const int wall = testing::add_species(scene, "wall", kForEver, 4);
  testing::block(scene, 0, 0, .9);
  testing::tether(scene, 0, 0, 1.8, .7, FormRule::When::always);
  testing::tether(scene, 0, wall, 3.4, 1, FormRule::When::permanent);
  add_particle(scene, wall, {});
  for (int n = 0; n < 6; ++n)
    add_particle(scene, 0, {-2 + 1.5 * (n % 3), n < 3 ? 1. : -1., 0}, {1. - .3 * n, .2 * n - .5, .1 * n});
  return scene;
}

// u + v (1 − e^{−γT})/γ and v e^{−γT}. In 113 bits nothing is rounded but s(T), to the double below it.
TEST(Drag, AFreeParticleFollowsTheClosedForm) {
  constexpr double u = 0x1p-53;
  for (const double gamma : {1e-9, .03, 1., 7.}) {
    for (const double T : {1e-3, 1., 5.}) {
      Scene scene = dragged(gamma, T);
      add_particle(scene, 0, {1, -2, 0}, {3, .25, 0});
      const RunSummary run = run_scene(scene, testing::options_for("quad"));
      const long double s = -std::expm1(-static_cast<long double>(gamma) * T) / gamma;
      const long double f = std::exp(-static_cast<long double>(gamma) * T);
      const auto& end = run.final_states.front();
      const auto way = static_cast<double>(3 * s);
      EXPECT_NEAR(std::stod(end.position[0]), 1 + way, 2 * u * way + 2 * u * (1 + way));
      EXPECT_NEAR(std::stod(end.velocity[1]), static_cast<double>(.25L * f), 3 * u * .25);
      EXPECT_EQ(run.t, T);
      EXPECT_EQ(run.end, "duration");
    }
  }
}

// A ball stops after the way |v|/γ: what is in its way within that is hit, at t = −ln(1 − γs)/γ, and what is
// not never is, however long the run. v/γ = 4 is exact; at 4 itself s = 1/γ, which is never.
TEST(Drag, NothingHappensBeyondTheStoppingDistance) {
  const auto with_gap = [](double gap) {
    Scene scene = dragged(.5, kForEver);
    testing::block(scene, 0, 0);
    add_particle(scene, 0, {0, 0, 0}, {2, 0, 0});
    add_particle(scene, 0, {1 + gap, 0, 0});
    return testing::traced(scene);
  };
  for (const double gap : {4., std::nextafter(5., 9) - 1, 4.5}) {
    const testing::TracedRun run = with_gap(gap);
    EXPECT_TRUE(run.events.empty()) << gap;
    EXPECT_EQ(run.summary.end, "no_more_events");
  }
  const testing::TracedRun near = with_gap(2);
  ASSERT_EQ(near.events.size(), 1U);
  EXPECT_EQ(near.events[0].s, 1);
  EXPECT_EQ(near.events[0].t, static_cast<double>(2 * std::log(2.L)));
  // The last place that is reached: γs = 1 − 2⁻⁵² or, rounded, a number beside it.
  const testing::TracedRun last = with_gap(std::nextafter(5., 0) - 1);
  ASSERT_EQ(last.events.size(), 1U);
  EXPECT_GT(last.events[0].t, 2 * 50.9 * std::log(2.));
  EXPECT_LT(last.events[0].t, 2 * 53.1 * std::log(2.));
}

TEST(Drag, TheRunIsThatOfTheSceneWithoutIt) {
  constexpr double gamma = .05;
  const testing::TracedRun slow = testing::traced(busy(Drag{gamma}));
  Scene scene = busy({});
  scene.duration = drag_clock_until(gamma, scene.duration);
  const testing::TracedRun free = testing::traced(scene);
  ASSERT_EQ(slow.events.size(), free.events.size());
  ASSERT_GE(slow.events.size(), 40U);
  for (std::size_t n = 0; n < slow.events.size(); ++n) {
    EXPECT_EQ(slow.events[n].exact_s, free.events[n].exact_t);
    EXPECT_EQ(slow.events[n].exact_dt, free.events[n].exact_dt);
    EXPECT_EQ(slow.events[n].dp, free.events[n].dp);
    // s has a second part, below half an ulp of the first.
    const double s = free.events[n].t;
    EXPECT_NEAR(slow.events[n].t, drag_time(gamma, dyadic(s), 0), 0x1p-52 * s / (1 - gamma * s)) << n;
    EXPECT_GT(slow.events[n].t, slow.events[n].s);
  }
}

// Without collisions K₀ (1 − e^{−2γT}) is drag's; with them the balance closes, in every scalar.
TEST(Drag, EnergyCloses) {
  Scene scene = dragged(.25, 3);
  add_particle(scene, 0, {}, {2, 1, 0});
  const RunSummary run = run_scene(scene, {});
  EXPECT_NEAR(*run.drag_taken, 2.5 * (1 - std::exp(-1.5)), 32 * 0x1p-53 * 2.5);
  EXPECT_EQ(run.lost, 0);
  for (const std::string& scalar : scalar_names()) {
    const RunSummary s = run_scene(busy(Drag{.05}), testing::options_for(scalar));
    EXPECT_LE(std::abs(s.energy_remainder), s.energy_bound) << scalar;
    EXPECT_LE(s.momentum_drift, s.momentum_bound) << scalar;
    EXPECT_GT(*s.drag_taken, .1) << scalar;
    EXPECT_GT(s.lost, .01) << scalar;
    EXPECT_NEAR(s.kinetic + s.lost + *s.drag_taken, s.kinetic_at_start, s.energy_bound + 1e-14) << scalar;
  }
}

// A threshold is a momentum of the scene: at t = 2 ln 2 it is a half of what the run's clock has.
TEST(Drag, ThresholdsAreMomentaOfTheScene) {
  const auto breaks = [](double threshold) {
    Scene scene = dragged(.5, 10);
    testing::tether(scene, 0, 0, 3, 1).tethering->breaks = {BreakRule::When::impulse_above, 0, threshold};
    add_particle(scene, 0, {0, 0, 0}, {0, 0, 0});
    add_particle(scene, 0, {2, 0, 0}, {1, 0, 0});
    scene.tethers = {{0, 1}};
    return testing::traced(scene).events.at(0).kind == "break";
  };
  EXPECT_TRUE(breaks(.499));  // s = 1, f = 1/2, |Δp| = 2 μ · 1 · f = 1/2
  EXPECT_FALSE(breaks(.5));
}

TEST(Drag, AResumedRunGoesOnToTheSameBytes) {
  for (const char* scalar : {"double", "quad"}) {
    RunOptions options = testing::options_for(scalar);
    options.state_every = 10;
    SCOPED_TRACE(scalar);
    const testing::ResumedRuns runs = testing::expect_same_when_resumed(busy(Drag{.05}), options);
    for (const RunSummary& resumed : runs.resumed) {
      EXPECT_EQ(resumed.drag_taken, runs.whole.drag_taken);
      EXPECT_EQ(resumed.lost, runs.whole.lost);
    }
  }
}

TEST(Drag, ASceneWithoutItHasNothingOfIt) {
  const testing::TracedRun run = testing::traced(busy({}));
  EXPECT_EQ(run.bytes.find("\"s\":"), std::string::npos);
  EXPECT_EQ(run.bytes.find("drag"), std::string::npos);
  EXPECT_FALSE(run.summary.drag_taken.has_value());
}

}  // namespace
}  // namespace drag_test
}  // namespace tps
