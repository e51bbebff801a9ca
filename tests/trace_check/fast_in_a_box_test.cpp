// Flights across many edges of a periodic box: whoever is met on the way is found by the check, whichever
// image it is, and what a flight costs is the number of edges that it crosses.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <random>

#include "tests/run/traced_run.hpp"
#include "tests/trace_check/checked_trace.hpp"
#include "verify/trace_check/rules/images_on_the_way.hpp"

namespace tps {
namespace fast_in_a_box {
namespace {

using nlohmann::json;

constexpr double kEdges[] = {8, 5, 6.5};
constexpr double kReach = 1;

/// One particle rests in the middle of the box, the other one starts at a place from there.
Scene pair_in_a_box(int dimension, const Coordinates& place, const Coordinates& velocity) {
  Scene scene = testing::plain_scene(dimension);
  scene.duration = 1;
  scene.box = PeriodicEdges{};
  scene.box->edges.fill(std::numeric_limits<double>::infinity());
  Coordinates middle{}, there{};
  for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k) {
    scene.box->edges[k] = kEdges[k];
    middle[k] = kEdges[k] / 2;
    there[k] = middle[k] + place[k];
  }
  testing::add_particle(scene, 0, middle, {});
  testing::add_particle(scene, 0, there, velocity);
  return scene;
}

/// The run of particles that do not see each other, told of a scene in which they rebound.
std::string unseen(const Scene& scene) {
  const testing::TracedRun blind = testing::traced(scene);
  const json law{{"between", {scene.species[0].name, scene.species[0].name}},
                 {"blocking", {{"distance", kReach}, {"c_rebound", 1}}}};
  std::string told;
  for (std::size_t n = 0; n < blind.lines.size(); ++n) {
    json line = json::parse(blind.lines[n]);
    if (line.contains("state")) continue;
    if (n == 0) line["scene"]["pairs"] = json::array({law});
    line.erase("checksum");
    told += line.dump() + "\n";
  }
  return told;
}

/// The least distance from any image, each looked at for itself.
double nearest_approach(const Scene& scene) {
  const Particle& p = scene.particles[1];
  std::array<int, 3> last{};
  for (std::size_t k = 0; k < 3; ++k) {
    if (std::isfinite(scene.box->edges[k]))
      last[k] = static_cast<int>(std::abs(p.velocity[k]) / scene.box->edges[k]) + 3;
  }
  double nearest = HUGE_VAL;
  for (int x = -last[0]; x <= last[0]; ++x) {
    for (int y = -last[1]; y <= last[1]; ++y) {
      for (int z = -last[2]; z <= last[2]; ++z) {
        const std::array<int, 3> n{x, y, z};
        double rr = 0, rv = 0, vv = 0;
        for (std::size_t k = 0; k < 3; ++k) {
          const double r =
              p.position[k] - scene.particles[0].position[k] + (n[k] == 0 ? 0 : n[k] * scene.box->edges[k]);
          rr += r * r;
          rv += r * p.velocity[k];
          vv += p.velocity[k] * p.velocity[k];
        }
        const double t = std::clamp(-rv / vv, 0., 1.);
        nearest = std::min(nearest, std::sqrt(std::max(0., rr + 2 * t * rv + t * t * vv)));
      }
    }
  }
  return nearest;
}

TEST(FastInABox, WhoIsMetIsFoundWhicheverImageItIs) {
  std::mt19937_64 random(20261126);
  std::uniform_real_distribution<double> unit(-1, 1);
  int met = 0, missed = 0;
  for (int n = 0; n < 150; ++n) {
    const int dimension = 2 + n % 2;
    Coordinates place{}, velocity{};
    for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k) {
      place[k] = kEdges[k] * unit(random) / 2;
      velocity[k] = (n % 5 == 0 ? 3 : dimension == 2 ? 60 : 25) * kEdges[k] * unit(random);
    }
    if (n % 7 == 0) velocity[1] = 0;
    const Scene scene = pair_in_a_box(dimension, place, velocity);
    double start = 0;
    for (std::size_t k = 0; k < 3; ++k) start += place[k] * place[k];
    const double nearest = nearest_approach(scene);
    if (start < 1.1 || std::abs(nearest - kReach) < 1e-6) continue;
    const check::CheckReport report = testing::checked(unseen(scene));
    EXPECT_EQ(testing::violated(report, check::Rule::earliest) > 0, nearest < kReach)
        << n << ": " << nearest << " " << testing::first_finding(report);
    ++(nearest < kReach ? met : missed);
  }
  EXPECT_GE(met, 30);
  EXPECT_GE(missed, 30);
}

/// How many images of its partner a flight may meet.
std::optional<std::size_t> images(const Coordinates& velocity) {
  const Scene scene = pair_in_a_box(3, {2, 2, 2}, velocity);
  const check::Model<double> model(scene, {.u = 0x1p-53, .smallest = 0x1p-1074});
  const auto found = check::images_on_the_way(model, 0, 1, 1., kReach);
  return found ? std::optional(found->size()) : std::nullopt;
}

TEST(FastInABox, ImagesAreAsManyAsEdgesAreCrossed) {
  for (const double speed : {8., 800., 8000.}) {
    const auto found = images({speed, .7 * speed, .4 * speed});
    ASSERT_TRUE(found.has_value());
    EXPECT_LE(*found, 12 * (1 + static_cast<std::size_t>(speed / 5)));
  }
  EXPECT_FALSE(images({1e6, 1, 1}).has_value());
  EXPECT_FALSE(images({1e300, 1e300, 1e300}).has_value());
}

}  // namespace
}  // namespace fast_in_a_box
}  // namespace tps
