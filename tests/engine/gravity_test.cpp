// Gravity against parabolas, a bouncing ball, and what a body that is held does not get.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/run/traced_run.hpp"

namespace tps {
namespace {

using testing::add_particle;

Scene falling(double every) {
  Scene scene = testing::plain_scene();
  scene.gravity = Gravity{{.25, -1, 0}, every};
  scene.duration = 4;
  return scene;
}

// Kicks at 0, 1/8, … with dyadic numbers: every position and velocity is exact. At a kick time, before the
// kick, u + v t + g t²/2; the velocity between kicks is that of the middle.
TEST(Gravity, KickTimesLieOnTheParabola) {
  Scene scene = falling(1. / 8);
  scene.duration = 4 - 1. / 16;
  add_particle(scene, 0, {1, 2, 0}, {3, -.5, 0});
  const int heavy = testing::add_species(scene, "heavy", 1e9, .5);
  add_particle(scene, heavy, {50, 2, 0}, {3, -.5, 0});
  const RunSummary run = run_scene(scene, {});
  EXPECT_EQ(run.by_kind.at("gravity"), 32U);
  const double t = 4 - 1. / 8, middle = t + 1. / 16;
  for (const int n : {0, 1}) {
    const auto& end = run.final_states[static_cast<std::size_t>(n)];
    const double vx = 3 + .25 * middle, vy = -.5 - middle;
    EXPECT_EQ(std::stod(end.velocity[0]), vx) << n;
    EXPECT_EQ(std::stod(end.velocity[1]), vy) << n;
    const double since = 1. / 16;
    EXPECT_EQ(std::stod(end.position[0]), (n == 0 ? 1 : 50) + 3 * t + .125 * t * t + since * vx) << n;
    EXPECT_EQ(std::stod(end.position[1]), 2 - .5 * t - .5 * t * t + since * vy) << n;
  }
}

// A ball on a floor of infinite mass loses what c takes and no more: its energy at the top of each flight is
// that of before times c², to the quadrature of the kicks, which falls with δ.
TEST(Gravity, ABallBouncesToWhereItsEnergyTakesIt) {
  for (const double every : {1e-2, 1e-3}) {
    Scene scene = testing::plain_scene();
    scene.gravity = Gravity{{0, -1, 0}, every};
    scene.duration = 4;
    const int floor = testing::add_species(scene, "floor", std::numeric_limits<double>::infinity(), 1e4);
    testing::block(scene, 0, floor, .8);
    add_particle(scene, floor, {0, -1e4, 0});
    add_particle(scene, 0, {0, 1.5, 0});  // falls by 1: rebound at √2, top at √2 + .8 √2
    const testing::TracedRun run = testing::traced(scene);
    for (const testing::TracedEvent& event : run.events) {
      if (event.kind != "rebound") continue;
      EXPECT_NEAR(event.t, std::sqrt(2.), every);
      const double after = event.post.at(1).velocity[1];
      EXPECT_NEAR(after, .8 * std::sqrt(2.), every);
      break;
    }
    EXPECT_LE(std::abs(run.summary.energy_remainder), run.summary.energy_bound);
    EXPECT_LE(run.summary.momentum_drift, run.summary.momentum_bound);
  }
}

// The relative motion of what falls together is not touched: a pair in free fall has the events of one at
// rest.
TEST(Gravity, FreeFallChangesNoCollision) {
  Scene scene = testing::plain_scene();
  scene.duration = 8;
  testing::block(scene, 0, 0, 1);
  testing::tether(scene, 0, 0, 3, 1);
  scene.tethers = {{0, 1}};
  add_particle(scene, 0, {0, 0, 0});
  add_particle(scene, 0, {2, 0, 0}, {-1, 0, 0});
  const testing::TracedRun at_rest = testing::traced(scene);
  scene.gravity = Gravity{{0, -1, 0}, 1. / 4};
  const testing::TracedRun falls = testing::traced(scene);
  std::vector<double> times;
  for (const testing::TracedEvent& event : falls.events) {
    if (event.kind != "gravity") times.push_back(event.t);
  }
  ASSERT_EQ(times.size(), at_rest.events.size());
  for (std::size_t n = 0; n < times.size(); ++n) EXPECT_EQ(times[n], at_rest.events[n].t) << n;
}

}  // namespace
}  // namespace tps
