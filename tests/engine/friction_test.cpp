// Rotation and friction against Walton's formulas in closed form, what they conserve, and two laws of gases
// of rough and of inelastic spheres.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>

#include "reference/engine/simulation.hpp"
#include "reference/engine/spin_coupling.hpp"
#include "tests/run/resumed_run.hpp"
#include "tests/run/traced_run.hpp"
#include "verify/scenes/granular.hpp"
#include "verify/scenes/rough.hpp"

namespace tps {
namespace friction_test {
namespace {

using testing::add_particle;

PairLaw& rub(Scene& scene, int a, int b, double c, double mu, double beta0) {
  PairLaw& law = testing::block(scene, a, b, c);
  law.friction = FrictionLaw{mu, beta0};
  return law;
}

/// Balls of two species that rub each other and a heavy one of infinite mass, in a container.
Scene busy(int dimension) {
  Scene scene = testing::plain_scene(dimension);
  scene.duration = 25;
  const int big = testing::add_species(scene, "big", 3, .75);
  const int post = testing::add_species(scene, "post", std::numeric_limits<double>::infinity(), .5);
  const int wall = testing::add_species(scene, "wall", std::numeric_limits<double>::infinity(), 4);
  rub(scene, 0, 0, .9, .4, .3);
  rub(scene, 0, big, 1, 2, -.5);
  rub(scene, 0, post, .8, .5, 1);
  testing::block(scene, big, big, 1);
  for (const int ball : {0, big}) testing::tether(scene, ball, wall, 3, 1, FormRule::When::permanent);
  add_particle(scene, wall, {});
  add_particle(scene, post, {.1, 0, 0});
  for (int n = 0; n < 4; ++n) {
    const int i = add_particle(scene, 0, {-2 + 1.4 * n, 1.5, 0}, {1. - .4 * n, -.6 + .1 * n, 0});
    set_spin(scene, static_cast<std::size_t>(i), {.5 * n, 0, 0});
  }
  add_particle(scene, big, {-1.2, -1.5, 0}, {.3, .4, 0});
  add_particle(scene, big, {1.2, -1.5, 0}, {-.2, .5, 0});
  return scene;
}

// A disc with backspin against a post: v_n = −1, g_t = 0.5 + R ω = 2.5. It holds (1 + β₀) κ m |g_t| = 5/6 · 2
// = 5/3 where β₀ = 1 and slides where μ (1 + c) m = 0.5: Δv = 0.5, Δω = Δv/(½ R).
TEST(Friction, ADiscAgainstAPost) {
  for (const double mu : {4., .25}) {
    Scene scene = testing::plain_scene();
    const int post = testing::add_species(scene, "post", std::numeric_limits<double>::infinity(), .5);
    rub(scene, 0, post, 1, mu, 1);
    add_particle(scene, 0, {-3, 0, 0}, {1, 0, 0});
    add_particle(scene, post, {});
    set_spin(scene, 0, {5, 0, 0});
    scene.duration = 3;
    const testing::TracedRun run = testing::traced(scene);
    ASSERT_EQ(run.events.size(), 1U);
    const auto& after = run.events[0].post.at(0);
    // g = v_B − v_A − (R ω) × û = −v_A − 2.5 ŷ; across: −2.5 ŷ, so that A is pushed along −y.
    const double J = mu > 1 ? 2 * 2.5 / 3 : mu * 2;
    EXPECT_NEAR(after.velocity[0], -1, 1e-15);
    EXPECT_NEAR(after.velocity[1], -J, 1e-15);
    EXPECT_NE(run.bytes.find(mu > 1 ? "\"contact\":\"sticks\"" : "\"contact\":\"slides\""),
              std::string::npos);
    EXPECT_NEAR(*run.summary.spin, .5 * .5 * .25 * std::pow(5 - J / .25, 2), 1e-14);
  }
}

TEST(Friction, EnergyCloses) {
  for (const int dimension : {2, 3}) {
    for (const std::string& scalar : scalar_names()) {
      const RunSummary s = run_scene(busy(dimension), testing::options_for(scalar));
      EXPECT_LE(std::abs(s.energy_remainder), s.energy_bound) << scalar;
      EXPECT_LE(s.momentum_drift, s.momentum_bound) << scalar;
      EXPECT_GT(std::abs(*s.spin - *s.spin_at_start), .01) << scalar;
      EXPECT_LT(s.energy_bound, scalar == "float" ? .5 : 1e-8) << scalar;
      EXPECT_GE(s.events, 30U);
    }
  }
}

TEST(Friction, AResumedRunGoesOnToTheSameBytes) {
  for (const int dimension : {2, 3}) {
    RunOptions options = testing::options_for("double");
    options.state_every = 10;
    const testing::ResumedRuns runs = testing::expect_same_when_resumed(busy(dimension), options);
    for (const RunSummary& resumed : runs.resumed) EXPECT_EQ(resumed.spin, runs.whole.spin);
  }
}

// Perfectly rough spheres (c = 1, β₀ = 1, always sticking) share the energy between motion and spin. Of 6N
// squares the membrane's centre, about which angular momentum is conserved, takes at most three, all of the
// motion's. The share of the spins of 3N : 3N has the variance 1/(4(3N + 1)) (a beta distribution); of M =
// 100 samples, five collisions of everybody apart, the mean is within 4 σ but for one seed in 16 000.
TEST(Friction, RoughSpheresShareTheirEnergyWithTheirSpins) {
  RoughParams params;
  params.particles = 30;
  params.restitution = 1;
  params.beta0 = 1;
  params.mu = 1e9;
  params.seed = 5;
  Scene scene = build_rough(params);
  scene.spins.clear();
  Simulation<double, 3> run(scene);
  const auto& turning = dynamic_cast<const SpinCoupling<double, 3>&>(*run.world().coupling);
  const double energy = kinetic_energy(run.world());
  const int N = params.particles, M = 100;
  double share = 0;
  for (int sample = -10; sample < M; ++sample) {
    for (int n = 0; n < 5 * N; ++n) run.step();
    if (sample >= 0) share += turning.energy(run.world()) / energy / M;
  }
  const double sigma = std::sqrt(1 / (4 * (3. * N + 1)) / M);
  EXPECT_GT(share, .5 - 4 * sigma);
  EXPECT_LT(share, 3. * N / (6 * N - 3) + 4 * sigma);
}

// Haff's law: smooth inelastic spheres lose (1 − e²) kT a collision on the average, whose size is
// exponentially distributed: x = ln E₀/E rises by 2 (1 − e²)/(3N) each, to a relative 1/√n after n; and y =
// √(E₀/E) − 1 rises linearly in time, to a relative (1 + x/2)/√n. Four σ, and 2 % for what velocities that
// are not Maxwell's do at e = .9 (second Sonine coefficient −.02, a half per cent of the rate).
TEST(Friction, GranularGasCoolsByHaffsLaw) {
  GranularParams params;
  params.particles = 200;
  params.restitution = .9;
  params.mu = 0;
  params.seed = 3;
  params.duration = 12;
  const Scene scene = build_granular(params);
  std::vector<double> slowing;
  double error = .02;
  for (const double until : {6., 12.}) {
    RunOptions options;
    options.until = until;
    const RunSummary s = run_scene(scene, options);
    const double n = static_cast<double>(s.by_kind.at("rebound"));
    const double x = std::log(s.kinetic_at_start / s.kinetic);
    const double expected = 2 * (1 - .81) / (3. * params.particles) * n;
    EXPECT_NEAR(x, expected, expected * (4 / std::sqrt(n) + .02));
    slowing.push_back(std::sqrt(s.kinetic_at_start / s.kinetic) - 1);
    error += 4 * (1 + x / 2) / std::sqrt(n);
    EXPECT_GT(x, .5);  // it has cooled by far more than the errors above
  }
  EXPECT_NEAR(slowing[1] / slowing[0], 2, 2 * error);
}

TEST(Friction, ASceneWithoutItHasNothingOfIt) {
  Scene scene = busy(3);
  for (PairLaw& law : scene.pairs) law.friction.reset();
  scene.spins.clear();
  const testing::TracedRun run = testing::traced(scene);
  EXPECT_EQ(run.bytes.find("spin"), std::string::npos);
  EXPECT_EQ(run.bytes.find("contact"), std::string::npos);
  EXPECT_FALSE(run.summary.spin.has_value());
}

}  // namespace
}  // namespace friction_test
}  // namespace tps
