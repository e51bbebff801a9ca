// Honest runs of scenes in small integers, where responses without restitution leave pairs at rest but for
// rounding: whatever the scalar and timing, no pair creeps, and the check says that every step follows.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <random>

#include "tests/run/traced_run.hpp"
#include "verify/certified/exact_timing.hpp"
#include "verify/trace_check/check.hpp"

namespace tps {
namespace {

using testing::add_particle;

class SmallIntegers {
 public:
  explicit SmallIntegers(unsigned seed) : random_(seed) {}

  /// Balls, heavy balls and a wall of infinite mass; most balls are aimed at the middle of another.
  Scene scene() {
    const int dimension = pick({2, 2, 3});
    Scene scene = testing::plain_scene(dimension);
    scene.duration = pick({20., 1000., 1e5});
    scene.species[0].radius = 1;
    const double heavy_radius = pick({1., 2.});
    testing::add_species(scene, "heavy", pick({1., 5., 1000.}), heavy_radius);
    testing::add_species(scene, "wall", std::numeric_limits<double>::infinity(), pick({1., 3.}));
    const double c = pick({0., 0., .5, 1., 1e-9, 1e-17});
    for (int a = 0; a < 3; ++a) {
      for (int b = a; b < 3; ++b) {
        if (a < 2 || b < 2) testing::block(scene, a, b, pick({c, c, 0., 1.}));
      }
    }
    if (pick({0, 0, 0, 1}) == 1) scene.grouping = Grouping{pick({.01, .1, 1.})};
    const Coordinates drift = {pick({0., 0., 0., 1., .1}), pick({0., 0., 1.}), 0};
    for (int n = pick({0, 1, 1, 2}); n > 0; --n) place(scene, 2, drift);
    for (int n = pick({1, 2, 3, 4}); n > 0; --n) {
      const Coordinates v = velocity(scene);
      place(scene, pick({0, 0, 1}), v);
    }
    return scene;
  }

  template <typename T>
  T pick(std::initializer_list<T> of) {
    return of.begin()[std::uniform_int_distribution<std::size_t>(0, of.size() - 1)(random_)];
  }

 private:
  Coordinates integers(const Scene& scene, int most) {
    std::uniform_int_distribution<int> integer(-most, most);
    Coordinates x{};
    for (std::size_t k = 0; k < static_cast<std::size_t>(scene.dimension); ++k) x[k] = integer(random_);
    return x;
  }

  /// Of the particle that place() will add at next_.
  Coordinates velocity(const Scene& scene) {
    next_ = integers(scene, 8);
    Coordinates v = integers(scene, 3);
    if (scene.particles.empty() || pick({0, 1, 1}) == 0) return v;
    const Coordinates& target = scene.particles.back().position;
    const double times = pick({1., 1., 2., .5});
    for (std::size_t k = 0; k < 3; ++k) v[k] = times * (target[k] - next_[k]);
    return v;
  }

  /// Unless it would overlap with another.
  void place(Scene& scene, int species, const Coordinates& v) {
    if (species == 2) next_ = integers(scene, 8);
    const auto radius = [&](int s) { return scene.species[static_cast<std::size_t>(s)].radius; };
    for (const Particle& p : scene.particles) {
      double square = 0;
      for (std::size_t k = 0; k < 3; ++k) square += std::pow(p.position[k] - next_[k], 2);
      if (square < std::pow(radius(species) + radius(p.species), 2)) return;
    }
    add_particle(scene, species, next_, v);
  }

  std::mt19937 random_;
  Coordinates next_{};
};

// Before directed rounding such runs crept through their limits and were refused.
TEST(SmallIntegerScenes, EveryRunConforms) {
  SmallIntegers generator(20261125);
  std::uint64_t events = 0;
  for (int n = 0; n < 400; ++n) {
    const Scene scene = generator.scene();
    if (scene.particles.size() < 2) continue;
    const std::string scalar = generator.pick({"double", "double", "float", "float", "long-double"});
    RunOptions options = testing::options_for(scalar, 1000);
    options.timing = generator.pick({Timing::stable, Timing::paper, Timing::certified});
    if (!can_be_timed(options.scalar, options.timing)) options.timing = Timing::stable;
    certified::ExactTiming certifier;
    options.certifier = &certifier;
    options.trace = testing::scratch("trace.ndjson");
    const RunSummary run = run_scene(scene, options);
    events += run.events;
    const check::CheckReport report = check::check_trace(options.trace);
    const std::string what = report.findings.empty() ? std::string() : report.findings.front().message;
    ASSERT_TRUE(report.conforming()) << n << ' ' << scalar << ' ' << run.end << ": " << what;
    if (options.timing == Timing::certified) {
      ASSERT_EQ(report.undecided(), 0U) << n << ' ' << what;
    }
  }
  EXPECT_GE(events, 800U);
  std::filesystem::remove(testing::scratch("trace.ndjson"));
}

// Forty ways of hitting a wall head-on without restitution, for a very long time: the ball stays where it is.
TEST(SmallIntegerScenes, ABallWithoutRestitutionRestsAtAWall) {
  for (int x = 1; x <= 8; ++x) {
    for (int y = -2; y <= 2; ++y) {
      Scene scene = testing::plain_scene();
      scene.duration = 1e12;
      const int wall = testing::add_species(scene, "wall", std::numeric_limits<double>::infinity(), .5);
      testing::block(scene, 0, wall, 0);
      add_particle(scene, wall, {0, 0, 0});
      add_particle(scene, 0, {3. * x, 3. * y, 0}, {-1. * x, -1. * y, 0});
      const RunSummary run = run_scene(scene, {});
      EXPECT_EQ(run.events, 1U) << x << ' ' << y;
      EXPECT_LE(run.audit_inner_excess, 4) << x << ' ' << y;  // the landing, and not one ulp more
    }
  }
}

}  // namespace
}  // namespace tps
