// A scene in other units is the same scene. Random scenes with every effect that changes energies, in units
// whose squares leave the scalar: no number of a summary is NaN or infinite, and no run accuses itself.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "reference/text/input_error.hpp"
#include "tests/run/traced_run.hpp"

namespace tps {
namespace units {
namespace {

using testing::add_particle;

/// Factors on lengths, times and masses: powers of two, so that a double has the same bits in any units.
struct Units {
  double length, time, mass;
  double speed() const { return length / time; }
  double momentum() const { return mass * speed(); }
  double energy() const { return momentum() * speed(); }
};

class RandomScene {
 public:
  explicit RandomScene(unsigned seed) : random_(seed) {}

  Scene in(const Units& u) {
    const int dimension = 2 + static_cast<int>(random_() % 2);
    Scene scene = testing::plain_scene(dimension);
    scene.duration = 6 * u.time;
    scene.seed = 7;
    scene.species[0].mass = of(.5, 2) * u.mass;
    scene.species[0].radius = .25 * u.length;
    const int heavy = testing::add_species(scene, "heavy", 16 * u.mass, .5 * u.length);
    testing::block(scene, 0, 0, of(.5, 1));
    testing::block(scene, 0, heavy, of(.5, 1));
    const auto effect = random_() % 8;
    if (effect == 0) {
      for (PairLaw& law : scene.pairs) law.friction = FrictionLaw{of(.1, 1), of(-1, 1)};
    }
    if (effect == 1) {
      testing::tether(scene, 0, heavy, 2 * u.length, of(0, 1), FormRule::When::always).tethering->c_revolve =
          .8;
      scene.clusters = ClusterObservation{0, 1};
    }
    if (effect == 2) scene.grouping = Grouping{.125 * u.time};
    if (effect == 3) scene.gravity = Gravity{{0, -.5 * u.speed() / u.time, 0}, .25 * u.time};
    if (effect == 4) scene.species[0].random_impulses = RandomImpulses{u.time, 2, .5 * u.momentum()};
    if (effect == 5) scene.species[0].thermostat = Thermostat{u.time, .5 * u.energy()};
    if (effect == 7) scene.drag = Drag{.25 / u.time};
    if (effect == 6) scene.impulses = {{2 * u.time, 1, {.5 * u.momentum(), u.momentum(), 0}}};
    for (int n = 0; n < 6; ++n) {
      const int i =
          add_particle(scene, n % 3 == 0 ? heavy : 0, {1.25 * n * u.length, of(-.25, .25) * u.length, 0},
                       {of(-1, 1) * u.speed(), of(-.25, .25) * u.speed(), 0});
      if (effect == 0) set_spin(scene, static_cast<std::size_t>(i), {of(-2, 2) / u.time, 0, 0});
    }
    return scene;
  }

 private:
  /// A float, whose bits no units change either.
  double of(double low, double high) {
    return static_cast<float>(low + (high - low) * static_cast<double>(random_() % 4096) / 4096);
  }
  std::mt19937 random_;
};

std::vector<double> numbers_of(const RunSummary& s) {
  std::vector<double> all = {s.momentum_drift,
                             s.momentum_bound,
                             s.kinetic_at_start,
                             s.kinetic,
                             s.stored,
                             s.lost,
                             s.work,
                             s.energy_remainder,
                             s.energy_bound,
                             s.spin_at_start.value_or(0),
                             s.spin.value_or(0)};
  for (const EffectEnergy& share : s.by_effect) all.push_back(share.energy);
  for (const ClusterSample& c : s.clusters) {
    for (const double x : {c.extent, c.relative_speed, c.centre_speed, c.mass}) all.push_back(x);
  }
  return all;
}

void expect_sound(const RunSummary& s) {
  for (const double x : numbers_of(s)) EXPECT_TRUE(std::isfinite(x)) << x;
  EXPECT_LE(std::abs(s.energy_remainder), s.energy_bound);
  EXPECT_LE(s.momentum_drift, s.momentum_bound);
}

/// Units in which masses and momenta are normal numbers, within 2^±most, energies above 2^least_energy, and
/// squares mostly not.
Units units_of(std::mt19937& random, int most, int least_energy) {
  const auto exponent = [&](int within) {
    return static_cast<int>(random() % (2U * static_cast<unsigned>(within) + 1)) - within;
  };
  for (;;) {
    const int mass = exponent(most), length = exponent(most), time = exponent(most);
    const int speed = length - time, energy = mass + 2 * speed;
    const bool fits = std::abs(speed) < most && std::abs(mass + speed) < most && energy < most &&
                      energy > least_energy && std::abs(speed - time) < most;
    if (fits) return {std::ldexp(1, length), std::ldexp(1, time), std::ldexp(1, mass)};
  }
}

TEST(Units, NoSummaryHasNumbersThatAreNoneAndNoRunAccusesItself) {
  std::mt19937 random(5);
  for (const std::string scalar : {"float", "double"}) {
    const int most = scalar == "float" ? 96 : 960;
    std::uint64_t events = 0, runs = 0;
    for (unsigned seed = 0; seed < 300; ++seed) {
      const Units u = units_of(random, most, -most * 3 / 2);  // energies also below the normal numbers
      SCOPED_TRACE(scalar + " " + std::to_string(seed));
      RunOptions options = testing::options_for(scalar, 60);
      try {
        const RunSummary s = run_scene(RandomScene(seed).in(u), options);
        if (s.end == "out_of_range") continue;
        expect_sound(s);
        events += s.events;
        ++runs;
      } catch (const InputError& refused) {
        continue;
      }
    }
    EXPECT_GE(runs, 200U) << scalar;
    EXPECT_GE(events, 2000U) << scalar;
  }
}

// In double all that a run computes is the same to the bit, so that its energies are those of the plain units
// by a power of two.
TEST(Units, EnergiesOfADoubleAreTheSameInAnyUnits) {
  std::mt19937 random(9);
  int compared = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    const Units u = units_of(random, 900, -900);
    const RunOptions options = testing::options_for("double", 40);
    const RunSummary plain = run_scene(RandomScene(seed).in({1, 1, 1}), options);
    RunSummary scaled;
    try {
      scaled = run_scene(RandomScene(seed).in(u), options);
    } catch (const InputError&) {
      continue;
    }
    if (scaled.end == "out_of_range" || plain.events != scaled.events) continue;
    ++compared;
    EXPECT_EQ(scaled.kinetic_at_start, plain.kinetic_at_start * u.energy()) << seed;
    EXPECT_EQ(scaled.kinetic, plain.kinetic * u.energy()) << seed;
    EXPECT_EQ(scaled.lost, plain.lost * u.energy()) << seed;
    EXPECT_EQ(scaled.work, plain.work * u.energy()) << seed;
    EXPECT_EQ(scaled.spin.value_or(0), plain.spin.value_or(0) * u.energy()) << seed;
    for (std::size_t n = 0; n < plain.clusters.size() && n < scaled.clusters.size(); ++n)
      EXPECT_EQ(scaled.clusters[n].extent, plain.clusters[n].extent * u.length) << seed;
  }
  EXPECT_GE(compared, 150);
}

}  // namespace
}  // namespace units
}  // namespace tps
