// Grouping of nearly simultaneous collisions, semantics §4.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "tests/run/traced_run.hpp"
#include "verify/scenes/gas.hpp"

namespace tps {
namespace {

using testing::add_particle;
using testing::add_species;
using testing::block;
using testing::plain_scene;
using testing::traced;
using testing::TracedEvent;
using testing::TracedRun;

/// Balls of diameter 1 in a row, `gap` apart, the first one moving with velocity 1; it arrives at t = 1.
Scene row(int n, double gap, double dt_restitute, double c = 1) {
  Scene scene = plain_scene();
  block(scene, 0, 0, c);
  for (int k = 0; k < n; ++k)
    add_particle(scene, 0, {k == 0 ? -2. : (k - 1) * (1 + gap), 0, 0}, {k == 0 ? 1. : 0., 0, 0});
  scene.grouping = Grouping{dt_restitute};
  scene.duration = 100;
  return scene;
}

TEST(Grouping, OneLoadAndOneRestitutionAreEq4) {
  for (const double c : {0., .5, .9, 1.}) {
    Scene scene = plain_scene();
    block(scene, 0, 0, c);
    add_particle(scene, 0, {0, 0, 0}, {1, .5, 0});
    add_particle(scene, 0, {3, .3, 0}, {-.25, .125, 0});
    const TracedRun free = traced(scene, "double");
    scene.grouping = Grouping{.125};
    scene.duration = 10;
    const TracedRun grouped = traced(scene, "double");
    ASSERT_EQ(free.events.size(), 1U);
    ASSERT_EQ(grouped.events.size(), 2U);
    EXPECT_EQ(grouped.events[0].exact_t, free.events[0].exact_t);
    EXPECT_EQ(grouped.events[0].post.at(0).exact_velocity, grouped.events[0].post.at(1).exact_velocity);
    EXPECT_EQ(grouped.events[0].members, (std::vector<int>{0, 1}));
    EXPECT_EQ(grouped.events[1].kind, "restitute");
    EXPECT_NEAR(grouped.events[1].dt, .125, 0);
    for (const int id : {0, 1}) {
      for (std::size_t k = 0; k < 2; ++k) {
        // Eqs. (6), (7), (3) round velocities below 1 five times instead of once.
        EXPECT_NEAR(grouped.events[1].post.at(id).velocity[k], free.events[0].post.at(id).velocity[k],
                    8 * 0x1p-53)
            << c;
      }
    }
    // Stored energy: |Δp_AB|²/2μ, all that v_load leaves of the relative motion along û times c².
    const TracedRun loaded = traced(scene, "double", 1);
    const double stored = loaded.events[0].dp_stored[0] * loaded.events[0].dp_stored[0] +
                          loaded.events[0].dp_stored[1] * loaded.events[0].dp_stored[1];
    EXPECT_NEAR(loaded.summary.stored, stored, 1e-15);  // μ = 1/2
    EXPECT_NEAR(grouped.summary.stored, 0, 1e-15);
  }
}

TEST(Grouping, ATetherPullLoadsAndRestitutesByEq5) {
  Scene scene = plain_scene();
  testing::tether(scene, 0, 0, 2, .5);
  scene.pairs[0].tethering->c_revolve = .5;
  add_particle(scene, 0, {0, 0, 0}, {0, -.5, 0});
  add_particle(scene, 0, {1.75, 0, 0}, {.125, .5, 0});
  scene.tethers = {{0, 1}};
  const TracedRun free = traced(scene, "double", 1);
  scene.grouping = Grouping{.125};
  const TracedRun grouped = traced(scene, "double", 2);
  EXPECT_EQ(free.events[0].kind, "revolve");
  EXPECT_EQ(grouped.events[0].kind, "revolve");
  EXPECT_EQ(grouped.events[1].kind, "restitute");
  for (const int id : {0, 1}) {
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_NEAR(grouped.events[1].post.at(id).velocity[k], free.events[0].post.at(id).velocity[k],
                  8 * 0x1p-53);
    }
  }
}

TEST(Grouping, MergesRenewTheExpiryAndUnwindFromTheRoot) {
  // 0 meets 1 at t = 1 (v_load 1/2), they meet 2 after .1/.5 (v_load 1/3), those 3 after .1·3.
  const double gap = .1;
  const TracedRun run = traced(row(4, gap, .4), "double", 6);
  ASSERT_EQ(run.events.size(), 6U);
  const std::vector<std::vector<int>> members = {{0, 1}, {0, 1, 2}, {0, 1, 2, 3}};
  for (std::size_t n = 0; n < 3; ++n) {
    EXPECT_EQ(run.events[n].members, members[n]);
    std::set<std::vector<std::string>> velocities;
    for (const int m : members[n]) velocities.insert(run.events[n].post.at(m).exact_velocity);
    EXPECT_EQ(velocities.size(), 1U) << "bitwise the same velocity";
    EXPECT_NEAR(run.events[n].t, 1 + (n > 0 ? .2 : 0) + (n > 1 ? .3 : 0), 1e-14);
  }
  // The first merge would have expired at 1.4, before the third load: every merge renewed it. Three nodes,
  // the last merge first, at one instant.
  const std::vector<std::pair<int, int>> order = {{2, 3}, {1, 2}, {0, 1}};
  for (std::size_t n = 0; n < 3; ++n) {
    const TracedEvent& e = run.events[3 + n];
    EXPECT_EQ(e.kind, "restitute");
    EXPECT_EQ(std::pair(e.i, e.j), order[n]);
    EXPECT_NEAR(e.t, 1.5 + .4, 1e-14);
    EXPECT_EQ(e.dt, n == 0 ? e.dt : 0);
    EXPECT_EQ(e.dp.size(), 2U);
  }
  EXPECT_EQ(run.events[3].post.at(2).exact_velocity[0], run.events[4].pre.at(2).exact_velocity[0]);
}

TEST(Grouping, PairsInsideAGroupHaveNoEvents) {
  Scene scene = row(5, 0, .25, .5);
  const TracedRun run = traced(scene, "double");
  std::set<int> group;
  for (const TracedEvent& e : run.events) {
    if (e.kind == "rebound") {
      EXPECT_FALSE(group.contains(e.i) && group.contains(e.j)) << e.k;
      if (!e.members.empty()) group = {e.members.begin(), e.members.end()};
    } else {
      group.clear();
    }
  }
}

/// A wall of infinite mass at the origin, balls that reach it from the right at the given times.
Scene walled(const std::vector<double>& arrivals, double dt_restitute) {
  Scene scene = plain_scene();
  const int wall = add_species(scene, "wall", HUGE_VAL, .5);
  block(scene, 0, 0);
  block(scene, 0, wall);
  add_particle(scene, wall, {0, 0, 0});
  for (std::size_t n = 0; n < arrivals.size(); ++n) {
    const double angle = 2 * static_cast<double>(n);
    const double from = 1 + arrivals[n];
    add_particle(scene, 0, {from * std::cos(angle), from * std::sin(angle), 0},
                 {-std::cos(angle), -std::sin(angle), 0});
  }
  scene.grouping = Grouping{dt_restitute};
  scene.duration = 50;
  return scene;
}

TEST(Grounding, KeepsTreesOnOneWallApart) {
  const TracedRun run = traced(walled({1, 1.25, 1.5}, .5), "double");
  ASSERT_EQ(run.events.size(), 6U);
  const std::vector<double> times = {1, 1.25, 1.5, 1.5, 1.75, 2};
  const std::vector<int> balls = {1, 2, 1, 3, 2, 3};  // restitution comes before the collision at 1.5
  std::map<int, double> loaded_at;
  for (std::size_t n = 0; n < 6; ++n) {
    const TracedEvent& e = run.events[n];
    EXPECT_NEAR(e.t, times[n], 1e-14);
    if (e.kind == "rebound") {
      loaded_at[e.j] = e.t;
      EXPECT_EQ(e.members, (std::vector<int>{e.j}));
      EXPECT_EQ(e.post.at(e.j).velocity, (std::vector<double>{0, 0}));
    } else {
      EXPECT_NEAR(e.t - loaded_at.at(e.j), .5, 1e-14);
    }
    EXPECT_EQ(e.i, 0);
  }
  EXPECT_EQ(run.summary.largest_group, 1U);
  EXPECT_EQ(std::count(balls.begin(), balls.end(), 1), 2);
}

TEST(Grounding, ABodyThatHitsAGroundedOneIsGroundedToo) {
  Scene scene = walled({1}, .5);
  add_particle(scene, 0, {3.25, 0, 0}, {-1, 0, 0});  // reaches ball 1 on the wall at t = 1.25
  const TracedRun run = traced(scene, "double");
  ASSERT_GE(run.events.size(), 4U);
  EXPECT_EQ(run.events[1].members, (std::vector<int>{1, 2}));
  EXPECT_EQ(run.events[1].post.at(2).velocity, (std::vector<double>{0, 0}));
  EXPECT_EQ(run.events[2].kind, "restitute");
  EXPECT_EQ(std::pair(run.events[2].i, run.events[2].j), std::pair(1, 2));
  EXPECT_EQ(run.events[2].t, 1.75);  // 1.25 + .5
  EXPECT_EQ(run.events[2].post.at(2).velocity[0], 1);
  EXPECT_EQ(run.events[3].post.at(1).velocity[0], 1);
}

TEST(Grouping, AnImpulseActsOnTheWholeBodyAndOnAGroundedOneNotAtAll) {
  Scene group = row(2, 0, 1);
  group.impulses = {{1.5, 0, {0, 3, 0}}};
  const TracedRun pushed = traced(group, "double", 2);
  EXPECT_EQ(pushed.events[1].kind, "scheduled_impulse");
  for (const int id : {0, 1})
    EXPECT_EQ(pushed.events[1].post.at(id).velocity, (std::vector<double>{.5, 1.5}));
  EXPECT_LE(std::abs(pushed.summary.energy_remainder), pushed.summary.energy_bound);

  Scene grounded = walled({1}, .5);
  grounded.impulses = {{1.25, 1, {0, 3, 0}}};
  const TracedRun held = traced(grounded, "double");
  ASSERT_EQ(held.events.size(), 3U);
  EXPECT_EQ(held.events[1].kind, "scheduled_impulse");
  EXPECT_EQ(held.events[1].post.at(1).velocity, (std::vector<double>{0, 0}));
  EXPECT_EQ(held.events[2].t, 1.5);  // an impulse renews no expiry
  EXPECT_EQ(held.events[2].post.at(1).velocity, (std::vector<double>{1, 0}));
  EXPECT_LE(held.summary.momentum_drift, held.summary.momentum_bound);
}

TEST(Grouping, BoundsTheNumberOfEvents) {
  for (const double dt : {.001, .01, .1}) {
    Scene scene = build_gas({.particles = 20, .density = .4, .restitution = .3, .duration = 1});
    scene.grouping = Grouping{dt};
    const RunSummary s = run_scene(scene, {});
    EXPECT_EQ(s.end, "duration");
    const double n = static_cast<double>(scene.particles.size());
    EXPECT_LE(static_cast<double>(s.events), 2 * (n - 1) * (1 / dt + 1));
    EXPECT_LE(std::abs(s.energy_remainder), s.energy_bound);
    EXPECT_LE(s.momentum_drift, s.momentum_bound);
  }
}

}  // namespace
}  // namespace tps
