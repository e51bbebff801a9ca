// Walls against reflections that are known exactly, against the particles of infinite mass that they
// resemble, and against the distribution of heights over a floor.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "reference/engine/simulation.hpp"
#include "reference/run/audit.hpp"
#include "tests/run/traced_run.hpp"
#include "verify/certified/exact_timing.hpp"

namespace tps {
namespace {

using testing::add_particle;
using testing::TracedEvent;

Wall plane(Coordinates through, Coordinates normal, double c = 1) {
  Wall wall;
  wall.point = through;
  wall.normal = normal;
  wall.c_rebound = c;
  return wall;
}
Wall sphere(Coordinates centre, double radius, bool inside, double c = 1) {
  Wall wall;
  wall.shape = Wall::Shape::sphere;
  wall.point = centre;
  wall.radius = radius;
  wall.inside = inside;
  wall.c_rebound = c;
  return wall;
}
Wall box(Coordinates low, Coordinates high, double c = 1) {
  Wall wall;
  wall.shape = Wall::Shape::box;
  wall.point = low;
  wall.high = high;
  wall.c_rebound = c;
  return wall;
}

void expect_ledger_closes(const RunSummary& run) {
  EXPECT_LE(std::abs(run.energy_remainder), run.energy_bound);
  EXPECT_LE(run.momentum_drift, run.momentum_bound);
}

/// Where a point that is reflected between 0 and `width` is: the unfolded path, folded back.
double folded(double x, double width) {
  const double turn = std::fmod(std::fmod(x, 2 * width) + 2 * width, 2 * width);
  return turn <= width ? turn : 2 * width - turn;
}

// A ball of radius ½ in a box of 4 × 3 with dyadic velocity: every time and place is exact, and along each
// axis it is the path of a free point, folded. Both speeds hit each wall in turn; the corner is met at once.
TEST(Walls, ABoxFoldsTheStraightPathExactly) {
  for (const Timing timing : {Timing::paper, Timing::stable, Timing::certified}) {
    certified::ExactTiming certifier;
    Scene scene = testing::plain_scene();
    scene.duration = 64;
    scene.walls = {box({0, 0, 0}, {4, 3, 0})};
    add_particle(scene, 0, {2, 1.5, 0}, {.75, -.25, 0});
    RunOptions options = testing::options_for("double");
    options.timing = timing;
    options.certifier = &certifier;
    const testing::TracedRun run = testing::traced(scene, options);
    ASSERT_GE(run.events.size(), 20U);
    for (const TracedEvent& event : run.events) {
      const auto& u = event.pre.at(0).position;
      EXPECT_EQ(u[0], .5 + folded(1.5 + .75 * event.t, 3)) << event.k;
      EXPECT_EQ(u[1], .5 + folded(1 - .25 * event.t, 2)) << event.k;
      EXPECT_EQ(std::abs(event.post.at(0).velocity[0]), .75);
      EXPECT_EQ(std::abs(event.post.at(0).velocity[1]), .25);
    }
    EXPECT_EQ(run.summary.worst_inner_excess, 0);
    EXPECT_EQ(run.summary.lost, 0);
    expect_ledger_closes(run.summary);
  }
}

// Into a corner along the diagonal: both faces are touched at exactly one moment, the lower face first.
TEST(Walls, ATieInACornerGoesByFaces) {
  certified::ExactTiming certifier;
  Scene scene = testing::plain_scene();
  scene.duration = 4;
  scene.walls = {box({0, 0, 0}, {4, 4, 0})};
  add_particle(scene, 0, {1.5, 1.5, 0}, {-1, -1, 0});
  RunOptions options = testing::options_for("double");
  options.timing = Timing::certified;
  options.certifier = &certifier;
  const testing::TracedRun run = testing::traced(scene, options);
  ASSERT_EQ(run.events.size(), 4U);
  EXPECT_EQ(run.events[0].t, 1);
  EXPECT_EQ(run.events[1].t, 1);
  EXPECT_NE(run.lines[2].find("\"wall\":0,\"face\":0"), std::string::npos) << run.lines[2];
  EXPECT_NE(run.lines[3].find("\"wall\":0,\"face\":2"), std::string::npos) << run.lines[3];
  EXPECT_EQ(run.events[3].post.at(0).velocity, (std::vector<double>{-1, -1}));
}

// From a leaning plane v' = v − (1 + c)(n·v) n, to rounding, wherever along it; what is along it is kept.
TEST(Walls, ALeaningPlaneReflects) {
  Scene scene = testing::plain_scene();
  scene.duration = 10;
  scene.walls = {plane({-3, 4, 0}, {.6, .8, 0}, .5)};
  add_particle(scene, 0, {4, 4, 0}, {-1, -2, 0});
  const testing::TracedRun run = testing::traced(scene);
  ASSERT_EQ(run.events.size(), 1U);
  const double normal = -.6 - 1.6;
  EXPECT_NEAR(run.events[0].t, (.6 * 7 - .5) / -normal, 1e-15);
  EXPECT_NEAR(run.events[0].post.at(0).velocity[0], -1 - 1.5 * normal * .6, 1e-15);
  EXPECT_NEAR(run.events[0].post.at(0).velocity[1], -2 - 1.5 * normal * .8, 1e-15);
  EXPECT_NEAR(run.summary.lost, .375 * normal * normal, 1e-15);
  expect_ledger_closes(run.summary);
}

/// The same events but for their names, to the bit.
void expect_same_flight(const testing::TracedRun& a, const testing::TracedRun& b, int id) {
  ASSERT_EQ(a.events.size(), b.events.size());
  ASSERT_GE(a.events.size(), 1U);
  for (std::size_t n = 0; n < a.events.size(); ++n) {
    EXPECT_EQ(a.events[n].exact_t, b.events[n].exact_t) << n;
    EXPECT_EQ(a.events[n].post.at(id).exact_velocity, b.events[n].post.at(id).exact_velocity) << n;
  }
}

// A sphere that particles are outside of is a particle of infinite mass that blocks them.
TEST(Walls, AnObstacleIsABlockingParticleOfInfiniteMass) {
  for (const Timing timing : {Timing::paper, Timing::stable, Timing::certified}) {
    certified::ExactTiming certifier;
    RunOptions options = testing::options_for("double");
    options.timing = timing;
    options.certifier = &certifier;
    Scene scene = testing::plain_scene(3);
    scene.duration = 30;
    add_particle(scene, 0, {-4, .3, .1}, {1, .01, .02});
    add_particle(scene, 0, {5, -.2, .7}, {-.7, .1, -.05});
    testing::block(scene, 0, 0, 1);
    Scene with_particle = scene;
    scene.walls = {sphere({.25, 0, 0}, 1.25, false, .875)};
    const int obstacle =
        testing::add_species(with_particle, "obstacle", std::numeric_limits<double>::infinity(), 1.25);
    testing::block(with_particle, 0, obstacle, .875);
    add_particle(with_particle, obstacle, {.25, 0, 0});
    const testing::TracedRun wall = testing::traced(scene, options);
    const testing::TracedRun particle = testing::traced(with_particle, options);
    ASSERT_GE(wall.summary.by_kind.at("wall"), 2U);
    ASSERT_EQ(wall.events.size(), particle.events.size());
    for (std::size_t n = 0; n < wall.events.size(); ++n) {
      EXPECT_EQ(wall.events[n].exact_t, particle.events[n].exact_t) << n;
      for (const auto& [id, state] : wall.events[n].post)
        EXPECT_EQ(state.exact_velocity, particle.events[n].post.at(id).exact_velocity) << n;
    }
  }
}

// One that they are inside of is a membrane, wherever retraction suffices.
TEST(Walls, AHollowIsAMembrane) {
  Scene scene = testing::plain_scene(3);
  scene.duration = 200;
  add_particle(scene, 0, {.5, .3, .1}, {1, .25, .2});
  Scene membrane = scene;
  scene.walls = {sphere({0, 0, 0}, 4, true)};
  const int around = testing::add_species(membrane, "membrane", std::numeric_limits<double>::infinity(), 4);
  testing::tether(membrane, 0, around, 3.5, 1, FormRule::When::permanent).tethering->theta_revolve_deg = .01;
  add_particle(membrane, around, {0, 0, 0});
  expect_same_flight(testing::traced(scene), testing::traced(membrane), 0);
}

// A piston that comes towards a ball does work on it: v' = 2 V − v, ΔK = 2 m V (V − v) along the normal.
TEST(Walls, AMovingWallDoesItsWork) {
  Scene scene = testing::plain_scene();
  scene.duration = 3;
  scene.walls = {plane({0, 0, 0}, {1, 0, 0}), plane({5, 0, 0}, {-1, 0, 0})};
  scene.walls[1].velocity = {-.25, 0, 0};
  add_particle(scene, 0, {1, 0, 0}, {3, 0, 0});
  const testing::TracedRun run = testing::traced(scene);
  ASSERT_GE(run.events.size(), 2U);
  EXPECT_EQ(run.events[0].post.at(0).velocity[0], -3.5);
  EXPECT_EQ(run.events[1].post.at(0).velocity[0], 3.5);
  EXPECT_EQ(run.summary.work, (3.5 * 3.5 - 9) / 2);
  expect_ledger_closes(run.summary);
}

// With c = 0 a ball rests on the floor: it never falls below it by more than its landing's rounding, and
// costs one event a kick.
TEST(Walls, ABallRestsOnTheFloor) {
  Scene scene = testing::plain_scene();
  scene.duration = 100;
  scene.gravity = Gravity{{0, -1, 0}, .125};
  scene.walls = {plane({0, 0, 0}, {0, 1, 0}, 0)};
  add_particle(scene, 0, {.3, .7, 0}, {.1, 0, 0});
  const RunSummary run = run_scene(scene, {});
  EXPECT_NEAR(std::stod(run.final_states[0].position[1]), .5, 1e-15);
  EXPECT_NEAR(std::stod(run.final_states[0].position[0]), .3 + .1 * 100, 1e-12);
  EXPECT_LE(run.by_kind.at("wall"), run.by_kind.at("gravity"));
  expect_ledger_closes(run);
}

// A ball that falls by 1 under g = 1 comes back to c² of that height, to what kicks at δ do to it.
TEST(Walls, ABallBouncesToTheSquareOfC) {
  for (const double every : {1e-2, 1e-3}) {
    Scene scene = testing::plain_scene();
    scene.duration = 6;
    scene.gravity = Gravity{{0, -1, 0}, every};
    scene.walls = {plane({0, 0, 0}, {0, 1, 0}, .8)};
    add_particle(scene, 0, {0, 1.5, 0});
    double speed = std::sqrt(2.);
    double t = speed;
    int bounces = 0;
    for (const TracedEvent& event : testing::traced(scene).events) {
      if (event.kind != "wall") continue;
      EXPECT_NEAR(event.t, t, (bounces + 1) * every);
      speed *= .8;
      EXPECT_NEAR(event.post.at(0).velocity[1], speed, (bounces + 1) * every);
      t += 2 * speed;
      ++bounces;
    }
    EXPECT_EQ(bounces, 3);
  }
}

// Heights over a floor in a bath are distributed as exp(−m g z/kT): the mean and its share above the mean,
// 1/e, within four standard errors (chance passes one once in 16 000 times); seeds are fixed. After ten mean
// times of the bath where a particle began is forgotten: e⁻¹⁰ of it is left.
TEST(Walls, HeightsOverAFloorAreBarometric) {
  Scene scene = testing::plain_scene();
  scene.species[0].thermostat = Thermostat{1, .5};
  scene.gravity = Gravity{{0, -1, 0}, .02};
  scene.walls = {plane({0, 0, 0}, {0, 1, 0})};
  const int particles = 200, samples = 6;
  for (int n = 0; n < particles; ++n) add_particle(scene, 0, {10. * n, .5 + .01 * (n % 100), 0});
  double sum = 0;
  int above = 0;
  scene.duration = 10.01;
  for (int k = 1; k <= samples; ++k) {
    scene.seed = static_cast<std::uint64_t>(k);
    for (const Coordinates& place : testing::positions_at_the_end(testing::traced(scene))) {
      const double height = place[1] - .5;
      EXPECT_GE(height, -1e-12);
      sum += height;
      above += height > .5 ? 1 : 0;
    }
  }
  const double n = particles * samples;
  const double mean = .5;  // kT/(m g)
  EXPECT_NEAR(sum / n, mean, 4 * mean / std::sqrt(n));
  const double share = std::exp(-1.);
  EXPECT_NEAR(above / n, share, 4 * std::sqrt(share * (1 - share) / n));
}

// What does not call for walls has no event or field of them.
TEST(Walls, AreNotThereUncalled) {
  Scene scene = testing::plain_scene();
  scene.duration = 10;
  testing::block(scene, 0, 0, 1);
  add_particle(scene, 0, {0, 0, 0}, {1, 0, 0});
  add_particle(scene, 0, {3, 0, 0});
  const testing::TracedRun run = testing::traced(scene);
  for (const char* text : {"\"wall\"", "\"walls\"", "\"face\""})
    EXPECT_EQ(run.bytes.find(text), std::string::npos) << text;
}

// The audit at the end of a run looks at everybody before every wall: one that is behind is found, however
// it came there, and told in ulps.
TEST(Walls, TheAuditFindsWhoIsBehindAWall) {
  Scene scene = testing::plain_scene();
  add_particle(scene, 0, {2, 1, 0}, {});
  const std::vector<std::pair<Wall, Coordinates>> walls = {
      {plane({0, 0, 0}, {1, 0, 0}), {.25, 1, 0}},  {plane({0, 0, 0}, {0, 1, 0}), {2, -3, 0}},
      {sphere({0, 0, 0}, 1, false), {1.25, 0, 0}}, {sphere({2, 2, 0}, 3, true), {2, -.75, 0}},
      {box({0, 0, 0}, {4, 4, 0}), {2, 3.75, 0}},
  };
  for (std::size_t n = 0; n < walls.size(); ++n) {
    scene.walls = {walls[n].first};
    Simulation<double, 2> run(scene);
    const BoundExcess<double> before = audit_bounds(run.world(), {1, 0});
    EXPECT_EQ(before.inner + before.outer, 0) << n;
    run.world().particles[0].position = {walls[n].second[0], walls[n].second[1]};
    const BoundExcess<double> behind = audit_bounds(run.world(), {1, 0});
    EXPECT_EQ(behind.outer > 0, n == 3) << n;                             // from inside of a sphere
    EXPECT_GE(std::max(behind.inner, behind.outer), .25 / 0x1p-50) << n;  // ulps of a coordinate up to 4
  }
}

// A particle whose walls are forgotten flies through one, and the audit says by how much.
TEST(Walls, TheAuditFindsARunThatForgetsItsWalls) {
  Scene scene = testing::plain_scene();
  add_particle(scene, 0, {2, 1, 0}, {-1, 0, 0});
  scene.walls = {plane({0, 0, 0}, {1, 0, 0})};
  Simulation<double, 2> run(scene);
  ASSERT_EQ(run.next_time().hi, 1.5);
  run.step();
  EXPECT_EQ(audit_bounds(run.world(), {4, 0}).inner, 0);
  run.world().particles[0].velocity = {-1, 0};  // as if it had not been turned
  EXPECT_EQ(audit_bounds(run.world(), {4, 0}).inner, 2.5 / 0x1p-51);
}

}  // namespace
}  // namespace tps
