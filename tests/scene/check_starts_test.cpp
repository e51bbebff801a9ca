// Which starts are contacts and which are violations, to the last bit.
#include "reference/scene/check_starts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "reference/scene/read_scene.hpp"
#include "reference/scene/write_scene.hpp"
#include "tests/support/processor_time.hpp"

namespace tps {
namespace {

constexpr double ulp_of_1 = 0x1p-52;

StartVerdict on_axis(double x, double limit) {
  return start_verdict({0, 0, 0}, {x, 0, 0}, limit);
}

TEST(StartVerdict, AllowsFourUlpOfTheLargestCoordinateAndNoMore) {
  EXPECT_EQ(on_axis(1, 1), StartVerdict::contact);
  EXPECT_EQ(on_axis(1 + 4 * ulp_of_1, 1), StartVerdict::contact);
  EXPECT_EQ(on_axis(1 + 5 * ulp_of_1, 1), StartVerdict::farther);
  // Below 1 an ulp of the coordinate is half as large.
  EXPECT_EQ(on_axis(1 - 4 * ulp_of_1 / 2, 1), StartVerdict::contact);
  EXPECT_EQ(on_axis(1 - 5 * ulp_of_1 / 2, 1), StartVerdict::nearer);
}

TEST(StartVerdict, CountsUlpsOfTheCoordinateNotOfTheDistance) {
  const double far = 0x1p20;
  const double ulp = 0x1p-32;
  const auto pair = [&](double gap) { return start_verdict({far, 0, 0}, {far + gap, 0, 0}, 1); };
  EXPECT_EQ(pair(1 + 4 * ulp), StartVerdict::contact);
  EXPECT_EQ(pair(1 + 5 * ulp), StartVerdict::farther);
  EXPECT_EQ(pair(1 - 4 * ulp), StartVerdict::contact);
  EXPECT_EQ(pair(1 - 5 * ulp), StartVerdict::nearer);
}

TEST(StartVerdict, IsExactAtTheEdgeOffTheAxes) {
  // A 3-4-5 triangle scaled by f, all of it representable: the distance is exactly 5 f, the allowance
  // 4 ulp(4) = 2^-48.
  const auto scaled = [](double f) { return start_verdict({0, 0, 0}, {3 * f, 4 * f, 0}, 5); };
  EXPECT_EQ(scaled(1 + 0x1p-51), StartVerdict::contact) << "0.625 of the allowance";
  EXPECT_EQ(scaled(1 + 0x1p-50), StartVerdict::farther) << "1.25 of the allowance";
  EXPECT_EQ(scaled(1 - 0x1p-51), StartVerdict::nearer) << "1.25 of the allowance, half as large just below 4";
  // A limit that is off by the allowance exactly is a contact still.
  EXPECT_EQ(start_verdict({0, 0, 0}, {3, 4, 0}, 5 - 0x1p-48), StartVerdict::contact);
  EXPECT_EQ(start_verdict({0, 0, 0}, {3, 4, 0}, 5 + 0x1p-48), StartVerdict::contact);
  EXPECT_EQ(start_verdict({0, 0, 0}, {3, 4, 0}, 5 - 0x1p-48 - 0x1p-50), StartVerdict::farther);
  EXPECT_EQ(start_verdict({0, 0, 0}, {3, 4, 0}, 5 + 0x1p-48 + 0x1p-50), StartVerdict::nearer);
}

TEST(StartVerdict, DoesNotDependOnTheOrderOrOnTheScale) {
  const Coordinates a = {0.1, 0.7, -0.3};
  const Coordinates b = {0.4, -0.2, 0.9};
  for (const int scale : {-1040, -600, 0, 600, 1020}) {
    const auto scaled = [&](const Coordinates& c) {
      return Coordinates{std::ldexp(c[0], scale), std::ldexp(c[1], scale), std::ldexp(c[2], scale)};
    };
    for (const double limit : {1.4, 1.6}) {
      const StartVerdict expected = limit < 1.5 ? StartVerdict::farther : StartVerdict::nearer;
      EXPECT_EQ(start_verdict(scaled(a), scaled(b), std::ldexp(limit, scale)), expected) << scale;
      EXPECT_EQ(start_verdict(scaled(b), scaled(a), std::ldexp(limit, scale)), expected) << scale;
    }
  }
}

TEST(StartVerdict, WorksAtTheEndsOfTheRange) {
  constexpr double max = std::numeric_limits<double>::max();
  constexpr double tiny = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(start_verdict({-max, 0, 0}, {max, 0, 0}, max), StartVerdict::farther);
  EXPECT_EQ(start_verdict({0, 0, 0}, {max, 0, 0}, max), StartVerdict::contact);
  EXPECT_EQ(start_verdict({0, 0, 0}, {0, 0, 0}, 5 * tiny), StartVerdict::nearer);
  EXPECT_EQ(start_verdict({0, 0, 0}, {0, 0, 0}, 4 * tiny), StartVerdict::contact);
}

// The good scenes that touch are tests of the allowance only if rounding leaves some of their pairs on the
// wrong side.
TEST(TouchingScenes, HaveContactsOnTheWrongSide) {
  const std::string folder = std::string(TPS_SOURCE_DIR) + "/tests/scene/good/";
  for (const char* name : {"cradle", "hexagonal_sheet"}) {
    const Scene scene = read_scene_file(folder + name + ".json");
    const long double limit = scene.pairs[0].blocking.value().distance;
    int contacts = 0;
    int overlaps = 0;
    for (std::size_t i = 0; i < scene.particles.size(); ++i) {
      for (std::size_t j = i + 1; j < scene.particles.size(); ++j) {
        long double square = 0;
        for (std::size_t k = 0; k < 3; ++k) {
          const long double r =
              static_cast<long double>(scene.particles[j].position[k]) - scene.particles[i].position[k];
          square += r * r;
        }
        contacts += std::fabs(std::sqrt(square) - limit) < 1e-12L ? 1 : 0;
        overlaps += std::sqrt(square) < limit ? 1 : 0;
      }
    }
    EXPECT_GE(contacts, static_cast<int>(scene.particles.size()) - 1) << name;
    EXPECT_GT(overlaps, 0) << name;
  }
  const Scene ring = read_scene_file(folder + "taut_ring.json");
  int overstretched = 0;
  for (const Tether& tether : ring.tethers) {
    const Coordinates& a = ring.particles[static_cast<std::size_t>(tether.i)].position;
    const Coordinates& b = ring.particles[static_cast<std::size_t>(tether.j)].position;
    const long double x = static_cast<long double>(b[0]) - a[0];
    const long double y = static_cast<long double>(b[1]) - a[1];
    overstretched += std::sqrt(x * x + y * y) > 1 ? 1 : 0;
  }
  EXPECT_EQ(ring.tethers.size(), 12U);
  EXPECT_GT(overstretched, 0);
}

// n^3 touching balls on a grid of spacing 1.
Scene grid(int n) {
  Scene scene;
  scene.dimension = 3;
  scene.duration = 1;
  scene.species = {{"ball", 1, 0.5, std::nullopt}, {"ghost", 1, 0.5, std::nullopt}};
  scene.pairs = {{0, 0, BlockingLaw{1, 1}, std::nullopt}};
  for (int x = 0; x < n; ++x) {
    for (int y = 0; y < n; ++y) {
      for (int z = 0; z < n; ++z) {
        Particle particle;
        particle.id = static_cast<int>(scene.particles.size());
        particle.position = {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
        scene.particles.push_back(particle);
      }
    }
  }
  return scene;
}

TEST(CheckStarts, TenThousandTouchingParticlesTakeSeconds) {
  const Scene scene = grid(22);
  const double start = processor_seconds();
  EXPECT_EQ(read_scene_text(write_scene(scene), "grid").particles.size(), 22U * 22U * 22U);
  EXPECT_LT(processor_seconds() - start, 60) << "quadratic work, not a measurement";
}

TEST(CheckStarts, SpeciesThatDoNotInteractMayOverlap) {
  Scene scene = grid(2);
  for (std::size_t k = 1; k < scene.particles.size(); ++k) scene.particles[k].species = 1;
  for (Particle& particle : scene.particles) particle.position = {0, 0, 0};
  EXPECT_EQ(read_scene_text(write_scene(scene), "ghosts"), scene);
}

TEST(CheckStarts, ParticlesOnOnePointAreReportedUpToACap) {
  Scene scene = grid(20);
  for (Particle& particle : scene.particles) particle.position = {0, 0, 0};
  try {
    read_scene_text(write_scene(scene), "heap");
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_EQ(error.problems().size(), InputProblems::max_kept);
  }
}

}  // namespace
}  // namespace tps
