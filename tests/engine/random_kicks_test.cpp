// Random impulses and the thermostat against their statistics. Seeds are fixed; each bound is four standard
// errors, which chance passes once in 16 000 times, so that a failure is a fault.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <vector>

#include "tests/run/traced_run.hpp"

namespace tps {
namespace {

using testing::add_particle;

/// Particles far from each other, in three dimensions, that no law joins.
Scene strangers(int count, double mass) {
  Scene scene = testing::plain_scene(3);
  scene.seed = 7;
  scene.species[0].mass = mass;
  for (int n = 0; n < count; ++n) add_particle(scene, 0, {100. * n, 0, 0});
  return scene;
}

std::map<int, std::vector<double>> times_by_particle(const testing::TracedRun& run, const std::string& kind) {
  std::map<int, std::vector<double>> times;
  for (const testing::TracedEvent& event : run.events) {
    if (event.kind == kind) times[event.i].push_back(event.t);
  }
  return times;
}

// τ = 2 and 100 particles for a time of 100: 5000 impulses, ± 71.
TEST(RandomImpulses, WaitExponentially) {
  Scene scene = strangers(100, 1);
  scene.duration = 100;
  scene.species[0].random_impulses = RandomImpulses{2, 3, .5};
  const testing::TracedRun run = testing::traced(scene);
  EXPECT_NEAR(static_cast<double>(run.events.size()), 5000, 4 * std::sqrt(5000.));
  double waits = 0, squares = 0, count = 0;
  for (const auto& [particle, times] : times_by_particle(run, "random_impulse")) {
    for (std::size_t n = 1; n < times.size(); ++n) {
      const double wait = times[n] - times[n - 1];
      waits += wait;
      squares += wait * wait;
      ++count;
    }
  }
  // Waiting times that the end cuts off are missing: about one of 50 a particle, which shortens the mean by 2
  // %.
  EXPECT_NEAR(waits / count, 2, .04 + 4 * 2 / std::sqrt(count));
  EXPECT_NEAR(squares / count / (waits / count) / (waits / count), 2, 4 * std::sqrt(20. / count));
}

// ⟨K⟩ grows by ⟨J²⟩/(2mτ) a unit of time, ⟨J²⟩ = mean² (1 + 1/shape); K of one particle is nearly χ² of three
// degrees, with a standard deviation of √(2/3) of its mean.
TEST(RandomImpulses, HeatByTheirMeanSquare) {
  constexpr int kParticles = 300;
  constexpr double kMass = 2.5, kTau = .5, kMean = .2, kShape = 2, kDuration = 40;
  Scene scene = strangers(kParticles, kMass);
  scene.duration = kDuration;
  scene.species[0].random_impulses = RandomImpulses{kTau, kShape, kMean};
  const RunSummary run = run_scene(scene, {});
  const double expected = kMean * kMean * (1 + 1 / kShape) * kDuration / (2 * kMass * kTau);
  EXPECT_NEAR(run.kinetic / kParticles, expected, 4 * expected * std::sqrt(2. / 3 / kParticles));
  EXPECT_LE(std::abs(run.energy_remainder), run.energy_bound);
  EXPECT_LE(run.momentum_drift, run.momentum_bound);
}

// The direction is uniform: ⟨J_k⟩ = 0, and each component has a third of ⟨J²⟩.
TEST(RandomImpulses, HaveNoDirection) {
  Scene scene = strangers(50, 1);
  scene.duration = 100;
  scene.species[0].random_impulses = RandomImpulses{1, 5, 1};
  const testing::TracedRun run = testing::traced(scene);
  std::array<double, 3> sum{}, square{};
  for (const testing::TracedEvent& event : run.events) {
    for (std::size_t k = 0; k < 3; ++k) {
      sum[k] += event.dp[k];
      square[k] += event.dp[k] * event.dp[k];
    }
  }
  const double n = static_cast<double>(run.events.size()), mean_square = 1.2;
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(sum[k] / n, 0, 4 * std::sqrt(mean_square / 3 / n));
    EXPECT_NEAR(square[k] / n, mean_square / 3, 4 * mean_square / 3 * std::sqrt(1.2 / n));
  }
}

// When a particle is pushed, and how, does not depend on what else happens to it.
TEST(RandomImpulses, AreTheSameWhateverElseHappens) {
  Scene scene = testing::plain_scene();
  scene.seed = 3;
  scene.duration = 30;
  scene.species[0].random_impulses = RandomImpulses{1, .5, .3};
  add_particle(scene, 0, {0, 0, 0}, {1, 0, 0});
  add_particle(scene, 0, {2, .3, 0});
  const testing::TracedRun apart = testing::traced(scene);
  testing::block(scene, 0, 0, .5);
  testing::tether(scene, 0, 0, 3, .5);
  scene.tethers = {{0, 1}};
  scene.grouping = Grouping{.01};
  const testing::TracedRun joined = testing::traced(scene);
  EXPECT_GT(joined.events.size(), apart.events.size());
  EXPECT_EQ(times_by_particle(apart, "random_impulse"), times_by_particle(joined, "random_impulse"));
}

// Two masses in one bath: ⟨m v²⟩ of each component is kT for both, after a few τ.
TEST(Thermostat, GivesEveryMassItsTemperature) {
  constexpr double kT = 1.7;
  Scene scene = strangers(400, 1);
  const int heavy = testing::add_species(scene, "heavy", 20, .5);
  for (int n = 0; n < 400; ++n) add_particle(scene, heavy, {100. * n, 50, 0}, {1, 1, 1});
  for (Species& species : scene.species) species.thermostat = Thermostat{1, kT};
  scene.duration = 12;
  const testing::TracedRun run = testing::traced(scene);
  std::map<int, std::vector<double>> last;
  for (const testing::TracedEvent& event : run.events) last[event.i] = event.post.at(event.i).velocity;
  for (const int first : {0, 400}) {
    double sum = 0;
    for (int n = first; n < first + 400; ++n) {
      for (const double v : last.at(n)) sum += (first == 0 ? 1. : 20.) * v * v;
    }
    EXPECT_NEAR(sum / 1200, kT, 4 * kT * std::sqrt(2. / 1200)) << first;
  }
}

// A tethered pair in a bath fills the shell between its limits evenly: ⟨r^p⟩ = d/(d+p) (R2^{d+p} − R1^{d+p})
// / (R2^d − R1^d) (docs/effects.md). Many pairs stand for a long time.
TEST(Thermostat, FillsTheShellOfATether) {
  constexpr int kPairs = 150;
  Scene scene = testing::plain_scene(3);
  scene.seed = 11;
  scene.duration = 12;
  scene.species[0].thermostat = Thermostat{1, 1};
  testing::block(scene, 0, 0, 1);
  PairLaw& law = testing::tether(scene, 0, 0, 1.5, 1);
  law.tethering->theta_revolve_deg = 1e-3;
  for (int n = 0; n < kPairs; ++n) {
    add_particle(scene, 0, {1e3 * n, 0, 0});
    add_particle(scene, 0, {1e3 * n + 1.2, 0, 0});
    scene.tethers.push_back({2 * n, 2 * n + 1});
  }
  RunOptions options;
  options.state_every = 1000000;
  const testing::TracedRun run = testing::traced(scene, options);
  const std::vector<Coordinates> end = testing::positions_at_the_end(run);
  double first = 0, second = 0;
  for (int n = 0; n < kPairs; ++n) {
    double square = 0;
    for (std::size_t k = 0; k < 3; ++k)
      square +=
          std::pow(end[static_cast<std::size_t>(2 * n + 1)][k] - end[static_cast<std::size_t>(2 * n)][k], 2);
    first += std::sqrt(square) / kPairs;
    second += square / kPairs;
  }
  // The standard deviation of r is √(1.66579 − 1.28289²) = 0.1413, that of r² at most 0.37.
  EXPECT_NEAR(first, 1.28289, 4 * .1413 / std::sqrt(kPairs));
  EXPECT_NEAR(second, 1.66579, 4 * .37 / std::sqrt(kPairs));
}

}  // namespace
}  // namespace tps
