// Answers of the engine that the equations alone do not show.
#include <gtest/gtest.h>

#include <cmath>

#include "reference/engine/simulation.hpp"
#include "tests/run/traced_run.hpp"

namespace tps {
namespace {

using testing::add_particle;
using Vec = Vector<double, 2>;

/// Lets the only effect of a scene respond to an event of particles 0 and 1 now, whether due or not.
Record<double, 2> respond_now(Simulation<double, 2>& simulation) {
  World<double, 2>& world = simulation.world();
  Record<double, 2> seen;
  world.sink = [&](const Record<double, 2>& record) { seen = record; };
  for (std::size_t n = 0; n < simulation.effects().size(); ++n) {
    if (!simulation.effects()[n]->predicts_pairs()) continue;
    simulation.effects()[n]->respond(world,
                                     world.pending(world.now, Rank::collision, 0, 1, 0, static_cast<int>(n)));
  }
  return seen;
}

Scene receding_contact() {
  Scene scene = testing::plain_scene();
  testing::block(scene, 0, 0);
  add_particle(scene, 0, {0, 0, 0}, {0, 0, 0});
  add_particle(scene, 0, {1, 0, 0}, {1e-16, 0, 0});
  return scene;
}

TEST(Response, AWrongSignAtTheInnerLimitStandsWithoutImpulse) {
  const Scene scene = receding_contact();
  Simulation<double, 2> simulation(scene);
  const Record<double, 2> record = respond_now(simulation);
  EXPECT_EQ(record.kind, "rebound");
  EXPECT_EQ(*record.dp, Vec(0, 0));
  EXPECT_EQ(simulation.world().velocity(1), Vec(1e-16, 0));
  EXPECT_EQ(simulation.world().statistics.zero_impulse, 1U);
  EXPECT_TRUE(simulation.world().responded.contains(0, 1, Limit::inner));
}

TEST(Response, AWrongSignLoadsNothingInAGroupedScene) {
  Scene scene = receding_contact();
  scene.grouping = Grouping{0.1};
  Simulation<double, 2> simulation(scene);
  const Record<double, 2> record = respond_now(simulation);
  EXPECT_EQ(record.addition, nullptr);
  EXPECT_FALSE(simulation.world().coupling->together(0, 1));
}

/// Three balls on a line: the middle one goes to and fro for ever, faster and faster, in no time at all.
Scene collapse(double c) {
  Scene scene = testing::plain_scene();
  scene.duration = 1e6;
  testing::block(scene, 0, 0, c);
  add_particle(scene, 0, {-2, 0, 0}, {1, 0, 0});
  add_particle(scene, 0, {0, 0, 0}, {.3, 0, 0});
  add_particle(scene, 0, {4.1, 0, 0}, {-2, 0, 0});
  return scene;
}

TEST(BelowRounding, ACollapseIsSeenInEveryScalar) {
  for (const char* scalar : {"float", "double", "long-double", "quad"}) {
    for (const double c : {.05, .01, .03}) {
      const RunSummary s = run_scene(collapse(c), testing::options_for(scalar));
      EXPECT_GT(s.noise, 0U) << scalar << ' ' << c;
      EXPECT_GT(s.first_noise, 2U) << scalar << ' ' << c;
      EXPECT_LE(s.first_noise, s.events) << scalar << ' ' << c;
    }
  }
}

TEST(BelowRounding, HonestCollisionsAreNot) {
  for (const double c : {1., .9, .5}) {
    const RunSummary s = run_scene(collapse(c), {});
    EXPECT_EQ(s.noise, 0U) << c;
    EXPECT_EQ(s.first_noise, 0U) << c;
  }
}

// A wider scalar sees farther: the first collision that it cannot tell comes later.
TEST(BelowRounding, AWiderScalarSeesMore) {
  const auto first = [](const char* scalar) {
    return run_scene(collapse(.05), testing::options_for(scalar)).first_noise;
  };
  EXPECT_LT(first("float"), first("double"));
  EXPECT_LT(first("double"), first("quad"));
}

TEST(Response, ARevolutionKeepsMomentumAndTakesAngularMomentum) {
  const double theta = 30;
  const double c_revolve = 0.7;
  Scene scene = testing::plain_scene();
  testing::tether(scene, 0, 0, 1, 0.9);
  scene.pairs[0].tethering->theta_revolve_deg = theta;
  scene.pairs[0].tethering->c_revolve = c_revolve;
  add_particle(scene, 0, {0, 0, 0}, {0, 0, 0});
  add_particle(scene, 0, {1, 0, 0}, {0, 1, 0});
  scene.tethers = {{0, 1}};
  Simulation<double, 2> simulation(scene);
  const Record<double, 2> record = respond_now(simulation);
  ASSERT_EQ(record.kind, "revolve");
  const Vec v_0 = simulation.world().velocity(0);
  const Vec v_1 = simulation.world().velocity(1);
  const double ulps = 8 * std::numeric_limits<double>::epsilon();  // a dozen roundings of numbers below 1
  EXPECT_NEAR(v_0[0] + v_1[0], 0, ulps);
  EXPECT_NEAR(v_0[1] + v_1[1], 1, ulps);
  // About the middle of the pair the angular momentum is r × v times a constant: 1 before.
  const double before = 1;
  const double after = v_1[1] - v_0[1];
  EXPECT_NEAR(after / before, std::pow(c_revolve, theta / 180) * std::cos(theta * pi<double>() / 180), ulps);
}

}  // namespace
}  // namespace tps
