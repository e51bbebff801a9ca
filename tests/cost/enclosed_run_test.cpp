// What is proven of a run: it is what the engine finds in 100 digits, and it ends where a start within the
// rounding of the scene's numbers may do otherwise.
#include "verify/cost/enclosed_run.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "verify/cost/traced_run.hpp"
#include "verify/scenes/gas.hpp"
#include "verify/scenes/pair.hpp"
#include "verify/scenes/three_body.hpp"

namespace tps::cost {
namespace {

std::vector<std::string> engine_events(const Scene& scene, std::uint64_t most) {
  RunOptions options;
  options.scalar = ScalarKind::mp100;
  options.max_events = most;
  return traced_run(scene, options).events;
}

Scene two_balls(Coordinates u_A, Coordinates v_A, Coordinates u_B) {
  Scene scene;
  scene.dimension = 2;
  scene.duration = 100;
  scene.species = {{.name = "ball", .mass = 1, .radius = 0.5, .max_tethers = {}}};
  scene.pairs = {{.species_a = 0,
                  .species_b = 0,
                  .blocking = BlockingLaw{.distance = 1, .c_rebound = 1},
                  .tethering = {}}};
  scene.particles = {{.id = 0, .species = 0, .position = u_A, .velocity = v_A},
                     {.id = 1, .species = 0, .position = u_B, .velocity = {}}};
  return scene;
}

TEST(EnclosedRun, ProvesThe70CollisionsOfXYZForEveryStart) {
  const Scene scene = build_three_body({});
  const EnclosedRun run = enclosed_run(scene, {});
  EXPECT_EQ(run.events.size(), 70U);
  EXPECT_EQ(run.ends_by, "end");
  EXPECT_EQ(run.events, engine_events(scene, 1000));
}

/// 200 rebounds and retractions in three dimensions; a tether on which a pair revolves or retracts, with
/// losses.
TEST(EnclosedRun, HasTheEventsThatTheEngineFindsIn100Digits) {
  GasParams params;
  params.particles = 20;
  params.duration = 1e6;
  const Scene gas = build_gas(params);
  const EnclosedRun of_gas = enclosed_run(gas, {Starts::rounding, 256, 200});
  EXPECT_EQ(of_gas.ends_by, "events");
  EXPECT_EQ(of_gas.events, engine_events(gas, 200));

  PairParams tethered;
  tethered.theta = 30;
  tethered.c_retract = 0.7;
  tethered.c_revolve = 0.9;
  tethered.duration = 1000;
  Scene pair = build_pair(tethered);
  pair.particles[1].position = {0.25, 0.5, 0};
  pair.pairs.front().blocking.reset();
  for (const double across : {0.25, 3.0}) {
    pair.particles[1].velocity = {1, across, 0};
    const EnclosedRun of_pair = enclosed_run(pair, {Starts::rounding, 256, 12});
    EXPECT_EQ(of_pair.ends_by, "events");
    EXPECT_EQ(of_pair.events, engine_events(pair, 12));
  }
}

/// A pass at L(1 − 2^-51), an ulp of the coordinates: half of it in each decides between hit and miss. The
/// stored start hits.
TEST(EnclosedRun, EndsWhereRoundingOfTheStartDecidesAVerdict) {
  const Scene graze = two_balls({-10, 3 - 0x1p-51, 0}, {1, 0, 0}, {0, 2, 0});
  EXPECT_EQ(enclosed_run(graze, {Starts::stored, 256, 10}).events.size(), 1U);
  const EnclosedRun every = enclosed_run(graze, {Starts::rounding, 256, 10});
  EXPECT_TRUE(every.events.empty());
  EXPECT_EQ(every.ends_by, "verdict");
}

/// Two pairs far apart meet at once, or an ulp after each other.
TEST(EnclosedRun, EndsWhereRoundingOfTheStartDecidesTheOrder) {
  for (const double later : {0.0, 0x1p-49}) {
    Scene scene = two_balls({-10, 0, 0}, {1, 0, 0}, {0, 0, 0});
    scene.particles.push_back(
        {.id = 2, .species = 0, .position = {-10 - later, 50, 0}, .velocity = {1, 0, 0}});
    scene.particles.push_back({.id = 3, .species = 0, .position = {0, 50, 0}, .velocity = {}});
    const EnclosedRun every = enclosed_run(scene, {});
    EXPECT_TRUE(every.events.empty());
    EXPECT_EQ(every.ends_by, "order");
    const EnclosedRun stored = enclosed_run(scene, {Starts::stored, 256, 10});
    EXPECT_EQ(stored.events.size(), later > 0 ? 2U : 0U);
    EXPECT_EQ(stored.ends_by, later > 0 ? "end" : "order");
  }
}

TEST(EnclosedRun, SaysWhatItCannotBegin) {
  const Scene touching = two_balls({-1, 0, 0}, {1, 0, 0}, {0, 0, 0});
  EXPECT_EQ(enclosed_run(touching, {}).ends_by, "start");
  ThreeBodyParams grouped;
  grouped.grouped = 1;
  EXPECT_EQ(why_not_enclosed(build_three_body(grouped)), "grouping");
  EXPECT_EQ(why_not_enclosed(build_three_body({})), "");
}

/// Fewer bits prove less, and never anything else.
TEST(EnclosedRun, InFewerBitsProvesABeginningOfTheSame) {
  GasParams params;
  params.particles = 20;
  params.duration = 1e6;
  const Scene gas = build_gas(params);
  const EnclosedRun narrow = enclosed_run(gas, {Starts::stored, 30, 300});
  const std::vector<std::string> truth = engine_events(gas, 300);
  ASSERT_LT(narrow.events.size(), 300U);
  EXPECT_GT(narrow.events.size(), 50U);
  EXPECT_TRUE(std::equal(narrow.events.begin(), narrow.events.end(), truth.begin()));
}

}  // namespace
}  // namespace tps::cost
