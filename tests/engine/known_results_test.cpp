// The analytic results that the engine must reproduce; derivations and sources are in docs/claims.md.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "tests/run/traced_run.hpp"
#include "verify/scenes/cradle.hpp"
#include "verify/scenes/galperin.hpp"
#include "verify/scenes/pair.hpp"
#include "verify/scenes/three_body.hpp"
#include "verify/scenes/two_anchors.hpp"

namespace tps {
namespace {

using testing::add_particle;
using testing::block;
using testing::options_for;
using testing::plain_scene;
using testing::traced;
using testing::TracedEvent;
using testing::TracedRun;

std::uint64_t rebounds(const RunSummary& summary) {
  const auto found = summary.by_kind.find("rebound");
  return found == summary.by_kind.end() ? 0 : found->second;
}

double final_vx(const RunSummary& summary, std::size_t n) {
  return std::stod(summary.final_states.at(n).velocity.at(0));
}

TEST(ThreeBody, HasSeventyReboundsAndTheWedgesVelocities) {
  for (const char* scalar : {"double", "mp50"}) {
    const RunSummary s = run_scene(build_three_body({}), options_for(scalar));
    EXPECT_EQ(s.end, "no_more_events");
    EXPECT_EQ(rebounds(s), 70U) << scalar;
    EXPECT_EQ(s.events, 70U) << scalar;
    // oracles.md prints 12 decimals; 70 collisions of rounding in double stay below half of the last one.
    EXPECT_NEAR(final_vx(s, 0), -.000461285096, 5e-13) << scalar;
    EXPECT_NEAR(final_vx(s, 1), .722243048177, 5e-13) << scalar;
    EXPECT_NEAR(final_vx(s, 2), .999739042048, 5e-13) << scalar;
  }
}

TEST(ThreeBody, CountFollowsTheMiddleMass) {
  const std::vector<std::pair<double, std::uint64_t>> table = {{1, 2},     {.1, 7},     {.01, 22},
                                                               {.001, 70}, {1e-4, 222}, {1e-6, 2221}};
  for (const auto& [mass, count] : table) {
    EXPECT_EQ(rebounds(run_scene(build_three_body({.middle_mass = mass}), {})), count) << mass;
  }
}

TEST(ThreeBody, CountFollowsTheRestitution) {
  const std::vector<std::pair<double, std::uint64_t>> table = {{.99, 70}, {.98, 72},  {.96, 78}, {.95, 85},
                                                               {.94, 97}, {.93, 120}, {.92, 194}};
  for (const auto& [e, count] : table) {
    EXPECT_EQ(rebounds(run_scene(build_three_body({.restitution = e}), {})), count) << e;
  }
}

TEST(ThreeBody, StallsBelowTheCollapseThreshold) {
  const RunSummary s = run_scene(build_three_body({.restitution = .9}), {});
  EXPECT_EQ(s.end, "stalled");
  EXPECT_EQ(s.stalled_on, (std::vector<std::string>{"0 (X)", "1 (Y)", "2 (Z)"}));
}

TEST(ThreeBody, GroupedTakesTwoCollisionsToTheExactVelocities) {
  struct Case {
    double c, x, y, z;
  };
  for (const Case& expected : {Case{1, -1. / 2001, 2000. / 2001, 2000. / 2001},
                               Case{.9, 991. / 20010, 1900. / 2001, 1900. / 2001}}) {
    ThreeBodyParams params;
    params.restitution = expected.c;
    params.grouped = .05;
    for (const char* scalar : {"double", "long-double", "mp50"}) {
      const RunSummary s = run_scene(build_three_body(params), options_for(scalar));
      EXPECT_EQ(s.end, "duration");
      EXPECT_EQ(rebounds(s) - s.noise, 2U) << scalar << ' ' << expected.c;
      // Y is 1000 times lighter: the error of its velocity is up to 1000 roundings of the momentum of X.
      const double bound = 4096 * 0x1p-53;
      EXPECT_NEAR(final_vx(s, 0), expected.x, bound);
      EXPECT_NEAR(final_vx(s, 1), expected.y, bound);
      EXPECT_NEAR(final_vx(s, 2), expected.z, bound);
    }
  }
}

TEST(Galperin, CountsTheDigitsOfPi) {
  const std::vector<std::uint64_t> pi = {3, 31, 314, 3141, 31415};
  for (const char* scalar : {"double", "long-double"}) {
    for (int digits = 0; digits < 5; ++digits) {
      const RunSummary s = run_scene(build_galperin({.digits = digits}), options_for(scalar));
      EXPECT_EQ(s.end, "no_more_events");
      EXPECT_EQ(rebounds(s), pi[static_cast<std::size_t>(digits)]) << scalar;
    }
  }
}

std::vector<double> relative_speeds(const TracedRun& run) {
  std::vector<double> speeds;
  for (const TracedEvent& e : run.events) {
    const auto& a = e.post.at(0).velocity;
    const auto& b = e.post.at(1).velocity;
    speeds.push_back(std::hypot(b[0] - a[0], b[1] - a[1]));
  }
  return speeds;
}

TEST(Revolution, FollowsTheTableToItsLastDigit) {
  const std::vector<double> times = {0, 1.681793, 3.681793, 6.060207, 8.888634};
  const std::vector<double> speeds = {.840896, .707107, .594604, .5, .420448};
  for (const char* scalar : {"double", "long-double", "quad"}) {
    const TracedRun run = traced(build_pair({}), scalar);
    ASSERT_EQ(run.events.size(), times.size());
    const std::vector<double> measured = relative_speeds(run);
    for (std::size_t n = 0; n < times.size(); ++n) {
      EXPECT_EQ(run.events[n].kind, "revolve");
      EXPECT_NEAR(run.events[n].t, times[n], 5e-7) << n;  // half of the last printed digit
      EXPECT_NEAR(measured[n], speeds[n], 5e-7) << n;
    }
  }
}

// From the second event on |c_retract v_n| = tan θ |v_ŵ| exactly: rounding decides, and with c_retract = 1
// a retraction keeps the speed where a revolution takes its share. Both are right (semantics §2).
TEST(Revolution, OnTheBoundaryEitherAnswerPasses) {
  PairParams params;
  params.c_retract = 1;
  const TracedRun run = traced(build_pair(params), "double");
  ASSERT_GE(run.events.size(), 5U);
  EXPECT_EQ(run.events.front().kind, "revolve");
  const std::vector<double> speeds = relative_speeds(run);
  double before = 1;
  for (std::size_t n = 0; n < run.events.size(); ++n) {
    const double kept = run.events[n].kind == "revolve" ? std::pow(.5, .25) : 1;
    EXPECT_NEAR(speeds[n], before * kept, 1e-14) << run.events[n].kind;
    if (n > 0) {
      EXPECT_NEAR(run.events[n].dt, 2 * std::sin(std::acos(-1) / 4) / before, 1e-14);
    }
    before = speeds[n];
  }
}

/// A tethered pair with R1 = 1, R2 = 1.5 whose relative motion has speed v and impact parameter b.
Scene billiard_pair(double b, double v) {
  Scene scene = plain_scene();
  block(scene, 0, 0);
  testing::tether(scene, 0, 0, 1.5);
  scene.pairs[0].tethering->theta_revolve_deg = 1;
  const double x = -std::sqrt(1.4 * 1.4 - b * b);  // between the limits, approaching
  add_particle(scene, 0, {0, 0, 0}, {-v / 2, 0, 0});
  add_particle(scene, 0, {x, b, 0}, {v / 2, 0, 0});
  scene.tethers = {{0, 1}};
  return scene;
}

TEST(TetheredPair, HasTheRadialPeriodOfTheAnnularBilliard) {
  for (const double b : {0., .3, .8, 1.1, 1.3}) {
    const double v = 1.75;
    const TracedRun run = traced(billiard_pair(b, v), "double", 60);
    const double inner = b < 1 ? std::sqrt(1 - b * b) : 0;
    const double period = 2 / v * (std::sqrt(1.5 * 1.5 - b * b) - inner);
    std::vector<double> outer;
    for (const TracedEvent& e : run.events) {
      EXPECT_NE(e.kind, "revolve");
      if (e.kind == "retract") outer.push_back(e.t);
    }
    ASSERT_GE(outer.size(), 25U);
    for (std::size_t n = 1; n < outer.size(); ++n) {
      // sqrt near-cancellation is harmless here; sixty events add a few roundings each.
      EXPECT_NEAR(outer[n] - outer[n - 1], period, 1e-12) << b;
    }
  }
}

TEST(TetheredPair, TurnsByTwiceTheArcCosineWhenItMissesTheInnerLimit) {
  const double b = 1.1;
  const TracedRun run = traced(billiard_pair(b, 1), "double", 20);
  const double turn = 2 * std::acos(b / 1.5);
  for (std::size_t n = 1; n < run.events.size(); ++n) {
    const auto direction = [&](const TracedEvent& e) {
      return std::atan2(e.pre.at(1).position[1] - e.pre.at(0).position[1],
                        e.pre.at(1).position[0] - e.pre.at(0).position[0]);
    };
    const double angle =
        std::remainder(direction(run.events[n]) - direction(run.events[n - 1]), 2 * std::acos(-1));
    EXPECT_NEAR(std::abs(angle), turn, 1e-13);
  }
}

TEST(EqualMassesOnALine, OnlyPermuteTheirVelocities) {
  for (const bool tethers : {false, true}) {
    Scene scene = plain_scene();
    block(scene, 0, 0);
    if (tethers) testing::tether(scene, 0, 0, 2.5);
    std::multiset<double> start;
    for (int n = 0; n < 8; ++n) {
      const double v = ((n * 5) % 8 - 3.5) / 4;
      start.insert(v);
      add_particle(scene, 0, {1.5 * n, 0, 0}, {v, 0, 0});
      if (tethers && n > 0) scene.tethers.push_back({n - 1, n});
    }
    const RunSummary s = run_scene(scene, options_for("double", 300));
    EXPECT_EQ(s.end, tethers ? "max_events" : "no_more_events");
    if (!tethers) {
      EXPECT_LE(s.events, 8U * 7U / 2U);
    }
    std::multiset<double> end;
    for (std::size_t n = 0; n < 8; ++n) end.insert(final_vx(s, n));
    auto expected = start.begin();
    // Each event leaves up to 4 roundings of a velocity below 1; particles take part in 300·2/8 of them.
    for (const double v : end) EXPECT_NEAR(v, *expected++, 4 * 75 * 0x1p-53) << tethers;
  }
}

TEST(Cradle, AsManyLeaveAsCame) {
  for (const int moving : {1, 2, 3}) {
    const RunSummary s = run_scene(build_cradle({.particles = 6, .moving = moving}), {});
    for (std::size_t n = 0; n < 6; ++n) {
      EXPECT_NEAR(final_vx(s, n), n + static_cast<std::size_t>(moving) >= 6 ? 1 : 0, 32 * 0x1p-53) << n;
    }
  }
}

TEST(TwoAnchors, StallUngroupedAndGoOnGrouped) {
  const RunSummary stalled = run_scene(build_two_anchors({}), {});
  EXPECT_EQ(stalled.end, "stalled");
  EXPECT_EQ(stalled.t, 0);
  EXPECT_EQ(stalled.stalled_on, (std::vector<std::string>{"0 (anchor)", "1 (anchor)", "2 (particle)"}));
  TwoAnchorsParams params;
  params.grouped = .01;
  const RunSummary grouped = run_scene(build_two_anchors(params), {});
  EXPECT_EQ(grouped.end, "duration");
  EXPECT_EQ(grouped.t, 1);
  EXPECT_LE(grouped.events, 2U * 2U * 101U);  // 2(N − 1)(T/Δt + 1)
  EXPECT_GE(grouped.events, 150U);
}

}  // namespace
}  // namespace tps
