// Minimal traces with gravity say no velocity behind a kick. Programs that round g δ and the sum in any of
// the usual ways conform; one whose g is wrong in a few of the last bits does not.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <random>

#include "tests/run/traced_run.hpp"
#include "tests/trace_check/checked_trace.hpp"

namespace tps {
namespace minimal_gravity {
namespace {

using nlohmann::json;
using testing::add_particle;
using testing::checked;
using testing::first_finding;

enum class Way { product_and_sum, fused, all_kicks_at_once, n_times_g };

constexpr int kKicks = 150, kKicksToAnImpulse = 50;
constexpr double kMass = 1.5;

struct Fall {
  double g, every;
};

/// A particle that falls, simulated here: kicks at nδ, and now and then an impulse, after which a line says
/// its velocity.
template <typename Scalar>
std::string told(const Fall& f, Way way, const char* scalar, int wrong_bits) {
  const auto g = static_cast<Scalar>(f.g);
  const Scalar own_g = g * (1 + static_cast<Scalar>(wrong_bits) * std::numeric_limits<Scalar>::epsilon());
  const auto every = static_cast<Scalar>(f.every);
  std::string events;
  json impulses = json::array();
  Scalar v = 0, said = 0, since = 0;
  double t = 0;
  for (int n = 0; n < kKicks; ++n) {
    const Scalar part = n == 0 ? Scalar(.5) : Scalar(1);
    since += part;
    if (way == Way::product_and_sum) v += part * (own_g * every);
    if (way == Way::fused) v = std::fma(part * own_g, every, v);
    if (way == Way::all_kicks_at_once) v = said + since * (own_g * every);
    if (way == Way::n_times_g) v = said + since * own_g * every;
    t = static_cast<Scalar>(n * f.every);
    events += json{{"t", t}, {"kind", "gravity"}}.dump() + "\n";
    if (n % kKicksToAnImpulse != kKicksToAnImpulse - 1) continue;
    const Scalar J = v / 128;
    t = static_cast<Scalar>((n + .5) * f.every);
    said = v += J / static_cast<Scalar>(kMass);
    since = 0;
    impulses.push_back({{"at", t}, {"particle", 0}, {"impulse", {0, static_cast<double>(J)}}});
    const json post = {{"0", {{"velocity", {0, static_cast<double>(v)}}}}};
    events += json{{"t", t}, {"kind", "scheduled_impulse"}, {"i", 0}, {"post", post}}.dump() + "\n";
  }
  const json scene = {{"tps", 1},
                      {"dimension", 2},
                      {"duration", 1e6},
                      {"species", {{"a", {{"mass", kMass}, {"radius", .5}}}}},
                      {"gravity", {{"acceleration", {0, f.g}}, {"every", f.every}}},
                      {"impulses", impulses},
                      {"particles", {{{"species", "a"}, {"position", {0, 0}}}}}};
  const json head = {{"trace", 1}, {"form", "minimal"}, {"scalar", scalar}, {"scene", scene}};
  const json end = {{"end", "max_events"}, {"events", kKicks + kKicks / kKicksToAnImpulse}, {"t", t}};
  return head.dump() + "\n" + events + end.dump() + "\n";
}

std::vector<Fall> falls(int count) {
  std::mt19937 random(2);
  const auto draw = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  std::vector<Fall> all;
  for (int n = 0; n < count; ++n) all.push_back({-draw(.2, 3), draw(.02, .3)});
  return all;
}

TEST(MinimalGravity, AnyUsualRoundingConforms) {
  for (const Fall& f : falls(40)) {
    for (const Way way : {Way::product_and_sum, Way::fused, Way::all_kicks_at_once, Way::n_times_g}) {
      const check::CheckReport of_double = checked(told<double>(f, way, "double", 0));
      ASSERT_EQ(of_double.findings.size(), 0U) << int(way) << ' ' << first_finding(of_double);
      const check::CheckReport of_float = checked(told<float>(f, way, "float", 0));
      ASSERT_EQ(of_float.findings.size(), 0U) << int(way) << ' ' << first_finding(of_float);
    }
  }
}

TEST(MinimalGravity, AWrongAccelerationIsTold) {
  for (const Fall& f : falls(20)) {
    for (const Way way : {Way::product_and_sum, Way::n_times_g})
      EXPECT_FALSE(checked(told<double>(f, way, "double", 1024)).findings.empty()) << f.g << ' ' << f.every;
  }
}

// The engine's own runs, in every scalar: its velocities behind kicks are those that the check makes.
TEST(MinimalGravity, OurOwnRunsConform) {
  for (const Fall& f : falls(10)) {
    Scene scene = testing::plain_scene();
    scene.duration = 2;
    scene.gravity = Gravity{{f.g, f.g / 3, 0}, f.every};
    scene.impulses = {{1.55, 0, {.125, .3, 0}}};
    add_particle(scene, 0, {}, {.5, 0, 0});
    for (const std::string& scalar : scalar_names()) {
      std::string small;
      for (const std::string& line : testing::traced(scene, testing::options_for(scalar)).lines) {
        json event = json::parse(line);
        if (event.contains("state")) continue;
        if (event.contains("trace"))
          event = {{"trace", 1}, {"form", "minimal"}, {"scalar", scalar}, {"scene", event["scene"]}};
        for (const char* key : {"k", "dt", "dv", "dp", "pre"}) event.erase(key);
        small += event.dump() + "\n";
      }
      const check::CheckReport report = checked(small);
      ASSERT_EQ(report.findings.size(), 0U) << f.g << ' ' << scalar << ": " << first_finding(report);
    }
  }
}

}  // namespace
}  // namespace minimal_gravity
}  // namespace tps
