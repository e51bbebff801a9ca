// A pair whose response left it an approach of rounding size sinks through its limit in time: that is one
// finding with a name of its own, and a faster one is not called so.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/run/traced_run.hpp"
#include "tests/trace_check/rows.hpp"
#include "verify/trace_check/check.hpp"

namespace tps::mutation {
namespace {

using check::CheckReport;
using check::Rule;

/// A ball flies head-on at a wall, or at another one that comes as fast, and stays there.
Scene sticking_scene(std::mt19937_64& random, bool wall) {
  std::uniform_real_distribution<double> number(.25, 2);
  Scene scene = testing::plain_scene(2);
  const int other = testing::add_species(scene, "other", wall ? HUGE_VAL : 1, .5);
  testing::block(scene, 0, other, 0);
  const double angle = number(random) * 3;
  const double speed = number(random);
  const double far = 1 + number(random);
  testing::add_particle(scene, 0, {-far * std::cos(angle), -far * std::sin(angle), 0},
                        {speed * std::cos(angle), speed * std::sin(angle), 0});
  const double back = wall ? 0 : -speed;
  testing::add_particle(scene, other, {0, 0, 0}, {back * std::cos(angle), back * std::sin(angle), 0});
  scene.duration = 4000;
  return scene;
}

/// The trace in which the first ball is left with an approach of `share` of its speed.
Trace sinking(const Scene& scene, Timing timing, double share) {
  Trace trace = run_of(scene, {"double", timing});
  Json& event = trace.lines.change(1);
  const Vec before = numbers(event.at("pre").at("0").at("velocity"));
  const Vec beside = numbers(event.at("post").at("1").at("velocity"));
  event["post"]["0"]["velocity"] = spelt(trace, Vec(beside + share * before));
  return trace;
}

struct Sunk {
  std::size_t creeping = 0, beyond = 0;
};

Sunk found_in(const Trace& trace) {
  const std::string path = testing::scratch("creep.ndjson");
  testing::write_bytes(path, text_of(trace));
  const CheckReport report = check::check_trace(path);
  Sunk found;
  found.beyond = report.of(Rule::bounds).violated;
  for (const check::Finding& f : report.findings) {
    if (f.rule == Rule::bounds && f.message.starts_with("creep: ")) ++found.creeping;
  }
  return found;
}

TEST(Creep, IsOneFindingWithItsOwnName) {
  std::mt19937_64 random(21);
  std::uniform_real_distribution<double> roundings(2, 16);
  for (int n = 0; n < 100; ++n) {
    const Scene scene = sticking_scene(random, n % 2 == 0);
    const Timing timing = n % 4 < 2 ? Timing::stable : Timing::certified;
    const Sunk found = found_in(sinking(scene, timing, roundings(random) * 0x1p-53));
    EXPECT_EQ(found.creeping, 1U) << n;
    EXPECT_EQ(found.beyond, 1U) << n;
  }
}

TEST(Creep, IsNotWhatMovesFaster) {
  std::mt19937_64 random(22);
  for (int n = 0; n < 100; ++n) {
    const Sunk found = found_in(sinking(sticking_scene(random, n % 2 == 0), Timing::stable, 0x1p-46));
    EXPECT_EQ(found.creeping, 0U) << n;
    EXPECT_EQ(found.beyond, 1U) << n;
  }
}

}  // namespace
}  // namespace tps::mutation
