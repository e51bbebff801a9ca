// The periodic box against times that are known exactly, against a search through images, with both
// detectors, and against the pressure and the collision rate of hard spheres.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "tests/run/traced_run.hpp"
#include "verify/certified/exact_timing.hpp"
#include "verify/scenes/gas.hpp"

namespace tps {
namespace {

using testing::add_particle;
using testing::TracedEvent;

constexpr double kOpen = std::numeric_limits<double>::infinity();

Scene boxed(double x, double y) {
  Scene scene = testing::plain_scene();
  scene.box = PeriodicEdges{{x, y, kOpen}};
  scene.duration = 64;
  testing::block(scene, 0, 0, 1);
  return scene;
}

template <typename Test>
void with_every_timing(Test test) {
  for (const Timing timing : {Timing::paper, Timing::stable, Timing::certified}) {
    for (const DetectorKind detector : {DetectorKind::all_pairs, DetectorKind::cells}) {
      certified::ExactTiming certifier;
      RunOptions options = testing::options_for("double");
      options.timing = timing;
      options.certifier = &certifier;
      options.detector = detector;
      test(options);
    }
  }
}

// Two balls of diameter 1 on a ring of 8: from 6 apart, that is 2 across the edge, they meet after 1 at
// speeds ½, exchange velocities, and meet on the other side each time after (8 − 2)/1.
TEST(PeriodicBox, TwoBallsMeetRoundTheRingForEver) {
  with_every_timing([](const RunOptions& options) {
    Scene scene = boxed(8, 8);
    add_particle(scene, 0, {1, 4, 0}, {-.5, 0, 0});
    add_particle(scene, 0, {7, 4, 0}, {.5, 0, 0});
    const testing::TracedRun run = testing::traced(scene, options);
    ASSERT_EQ(run.events.size(), 11U);
    for (std::size_t n = 0; n < run.events.size(); ++n) {
      EXPECT_EQ(run.events[n].t, 1 + 6. * static_cast<double>(n));
      EXPECT_EQ(run.events[n].post.at(0).velocity[0], n % 2 == 0 ? .5 : -.5);
    }
    EXPECT_EQ(run.summary.worst_inner_excess, 0);
  });
}

// One ball stands; the other runs round the box, past it for many turns, until its slow drift upwards brings
// it into the way: at height −1 + t/64 it hits head-on offsets below 1.
TEST(PeriodicBox, ALongFlightCrossesManyEdges) {
  with_every_timing([](const RunOptions& options) {
    Scene scene = boxed(8, 32);
    add_particle(scene, 0, {4, 16, 0});
    add_particle(scene, 0, {0, 12, 0}, {4, 1. / 16, 0});
    const testing::TracedRun run = testing::traced(scene, options);
    ASSERT_GE(run.events.size(), 1U);
    // Centres pass within x of each other at t = 1 + 2n; it touches once |y| ≤ 1 there, at y = −4 + t/16.
    const double t = run.events[0].t;
    EXPECT_GT(t, 47);
    EXPECT_LT(t, 51);
    const auto& u = run.events[0].pre.at(1).position;
    EXPECT_NEAR(std::hypot(std::remainder(u[0] - 4, 8), u[1] - 16), 1, 1e-12);
    EXPECT_GT(u[0], 190);  // positions are not wrapped
  });
}

/// When a pair first touches by any of the images around, from r and v in long double: eq. (2), the smaller
/// root.
long double first_touch(const Coordinates& r, const Coordinates& v, double edge, int reach) {
  long double first = HUGE_VALL;
  for (int i = -reach; i <= reach; ++i) {
    for (int j = -reach; j <= reach; ++j) {
      const long double x = r[0] + i * static_cast<long double>(edge),
                        y = r[1] + j * static_cast<long double>(edge);
      const long double a = v[0] * static_cast<long double>(v[0]) + v[1] * static_cast<long double>(v[1]);
      const long double h = x * v[0] + y * v[1];
      const long double c = x * x + y * y - 1;
      const long double D = h * h - a * c;
      if (h < 0 && D > 0) first = std::min(first, c / (std::sqrt(D) - h));
    }
  }
  return first;
}

// The first event of random scenes is the earliest of all pairs and images.
TEST(PeriodicBox, TheFirstEventIsTheEarliestOfAllImages) {
  std::mt19937_64 random(3);
  for (int n = 0; n < 60; ++n) {
    const double edge = 2.5 + .5 * static_cast<double>(random() % 12);
    const auto uniform = [&](double low, double high) {
      return std::uniform_real_distribution<double>(low, high)(random);
    };
    Scene scene = boxed(edge, edge);
    scene.duration = 12;
    add_particle(scene, 0, {uniform(.1, .6), uniform(.1, edge - .1), 0}, {uniform(-2, 2), uniform(-2, 2), 0});
    add_particle(scene, 0, {uniform(1.7, edge - .7), uniform(.1, edge - .1), 0},
                 {uniform(-2, 2), uniform(-2, 2), 0});
    Coordinates r{}, v{};
    for (std::size_t k = 0; k < 2; ++k) {
      r[k] = scene.particles[1].position[k] - scene.particles[0].position[k];
      v[k] = scene.particles[1].velocity[k] - scene.particles[0].velocity[k];
    }
    const long double right = first_touch(r, v, edge, 24);
    with_every_timing([&](RunOptions options) {
      options.max_events = 1;
      const testing::TracedRun run = testing::traced(scene, options);
      ASSERT_EQ(run.events.empty(), !(right < scene.duration)) << n;
      if (run.events.empty()) return;
      EXPECT_NEAR(static_cast<double>(run.events[0].t / right), 1, 1e-11) << n;
    });
  }
}

// A tethered pair across the corner of the box has the events of one in its middle: places are moved by
// multiples of 1/4, at first exactly, and velocities do not know of it.
TEST(PeriodicBox, ATetherHoldsAcrossTheCorner) {
  const auto pair_at = [](double x, double y) {
    Scene scene = boxed(8, 8);
    testing::tether(scene, 0, 0, 1.75, 1);
    scene.pairs.erase(scene.pairs.begin(), scene.pairs.end() - 1);
    scene.tethers = {{0, 1}};
    scene.duration = 12;
    const auto inside = [](double c) { return c - 8 * std::floor(c / 8); };
    add_particle(scene, 0, {inside(x - .625), inside(y - .25), 0}, {.5, .25, 0});
    add_particle(scene, 0, {inside(x + .625), inside(y + .25), 0}, {.125, -.75, 0});
    return testing::traced(scene);
  };
  const testing::TracedRun middle = pair_at(4, 4), corner = pair_at(8, 8);
  ASSERT_GE(middle.events.size(), 8U);
  ASSERT_EQ(middle.events.size(), corner.events.size());
  for (std::size_t n = 0; n < 8; ++n) {
    EXPECT_EQ(middle.events[n].kind, corner.events[n].kind);
    EXPECT_NEAR(middle.events[n].t, corner.events[n].t, 1e-10);
    EXPECT_NEAR(middle.events[n].post.at(0).velocity[0], corner.events[n].post.at(0).velocity[0], 1e-10);
  }
}

// Cells and all pairs: the same bytes, dense and dilute, in every timing; grouped as well.
TEST(PeriodicBox, DetectorsAgreeToTheByte) {
  for (const double density : {.05, .5, .8}) {
    for (const double grouped : {0., .01}) {
      GasParams params;
      params.particles = density < .1 ? 40 : 108;
      params.density = density;
      params.periodic = 1;
      params.grouped = grouped;
      params.restitution = grouped > 0 ? .9 : 1;
      params.duration = density < .1 ? 20 : 1;
      const Scene scene = build_gas(params);
      for (const char* scalar : {"float", "double"}) {
        for (const Timing timing : {Timing::stable, Timing::certified}) {
          certified::ExactTiming certifier;
          RunOptions options = testing::options_for(scalar, 600);
          options.timing = timing;
          options.certifier = &certifier;
          options.detector = DetectorKind::all_pairs;
          const testing::TracedRun all = testing::traced(scene, options);
          options.detector = DetectorKind::cells;
          EXPECT_EQ(testing::traced_bytes(scene, options), all.bytes) << density << ' ' << grouped << scalar;
          EXPECT_GE(all.events.size(), 50U);
        }
      }
    }
  }
}

/// Mean and standard error of the mean, of blocks.
struct Estimate {
  double mean, error;
};
Estimate estimate(const std::vector<double>& blocks) {
  double mean = 0, square = 0;
  const auto n = static_cast<double>(blocks.size());
  for (const double x : blocks) mean += x / n;
  for (const double x : blocks) square += (x - mean) * (x - mean);
  return {mean, std::sqrt(square / (n * (n - 1)))};
}

// Hard spheres of density .5: Z = 1 + Σ r·Δp/(3 N kT t) is that of Carnahan and Starling, the collision rate
// of a particle 4√π ρ χ √(kT/m) that of Enskog, within four standard errors of ten blocks (chance passes one
// once in 1000, by Student's t with nine degrees of freedom) and 2/N of it for what a finite box changes.
// From .5 on: docs/effects.md has .7 and longer runs.
TEST(PeriodicBox, HardSpheresHaveTheirPressureAndTheirRate) {
  GasParams params;
  params.particles = 256;
  params.density = .5;
  params.periodic = 1;
  params.duration = 8;
  const Scene scene = build_gas(params);
  const testing::TracedRun run = testing::traced(scene);
  const double N = params.particles, warm_up = 3, blocks = 10;
  const double kT = 2 * run.summary.kinetic_at_start / (3 * (N - 1));
  const double edge = scene.box->edges[0];
  const double density = N / (edge * edge * edge);
  const double length = (params.duration - warm_up) / blocks;
  std::vector<double> virial(10, 1.), rate(10, 0.);
  for (const TracedEvent& event : run.events) {
    if (event.t < warm_up) continue;
    const auto block = static_cast<std::size_t>((event.t - warm_up) / length);
    double r_dp = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double r = event.pre.at(event.j).position[k] - event.pre.at(event.i).position[k];
      r_dp -= std::remainder(r, edge) * event.dp[k];
    }
    virial.at(block) += r_dp / (3 * N * kT * length);
    rate.at(block) += 2 / (N * length);
  }
  const double eta = std::numbers::pi / 6 * density;
  const double Z = (1 + eta + eta * eta - eta * eta * eta) / std::pow(1 - eta, 3);
  const double chi = (1 - eta / 2) / std::pow(1 - eta, 3);
  const double enskog = 4 * std::sqrt(std::numbers::pi * kT) * density * chi;
  const Estimate pressure = estimate(virial), collisions = estimate(rate);
  RecordProperty("Z", std::to_string(pressure.mean));
  EXPECT_NEAR(pressure.mean, Z, 4 * pressure.error + 2 / N * Z);
  EXPECT_NEAR(collisions.mean, enskog, 4 * collisions.error + 2 / N * enskog);
  EXPECT_LT(pressure.error, .05 * Z);
  EXPECT_LT(collisions.error, .05 * enskog);
}

// Uncalled it has no field.
TEST(PeriodicBox, IsNotThereUncalled) {
  Scene scene = boxed(8, 8);
  scene.box.reset();
  add_particle(scene, 0, {1, 4, 0}, {-.5, 0, 0});
  add_particle(scene, 0, {7, 4, 0}, {.5, 0, 0});
  const testing::TracedRun run = testing::traced(scene);
  EXPECT_TRUE(run.events.empty());
  EXPECT_EQ(run.bytes.find("\"box\""), std::string::npos);
}

}  // namespace
}  // namespace tps
