// Both ends of a scalar's range: a scene that it cannot hold is refused, a run that leaves it ends so, and no
// file holds a NaN.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>
#include <string>

#include "reference/scene/read_scene.hpp"
#include "reference/text/input_error.hpp"
#include "tests/run/traced_run.hpp"
#include "verify/certified/exact_timing.hpp"

namespace tps {
namespace {

using testing::add_particle;

/// Two balls that approach, at lengths and speeds times powers of ten, with a tether or without.
Scene approaching(double length, double speed, double mass, bool tethered) {
  Scene scene = testing::plain_scene();
  scene.duration = 100 * length / speed;
  scene.species[0].mass = mass;
  scene.species[0].radius = length / 2;
  testing::block(scene, 0, 0, 1);
  if (tethered) {
    testing::tether(scene, 0, 0, 4 * length, .5);
    scene.tethers = {{0, 1}};
  }
  add_particle(scene, 0, {0, 0, 0}, {speed / 2, 0, 0});
  add_particle(scene, 0, {3 * length, length / 4, 0}, {-speed / 2, 0, 0});
  return scene;
}

struct Ending {
  std::string end;  ///< "refused", or as the run says
  std::uint64_t events = 0;
  std::string bytes;
};

Ending ending_of(const Scene& scene, const std::string& scalar, Timing timing) {
  RunOptions options = testing::options_for(scalar, 20);
  certified::ExactTiming certifier;
  options.timing = timing;
  options.certifier = &certifier;
  try {
    const testing::TracedRun run = testing::traced(scene, options);
    return {run.summary.end, run.summary.events, run.bytes};
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find(scalar), std::string::npos) << error.what();
    return {"refused", 0, {}};
  }
}

// Every scene of this kind has events: a run sees the first, or says why not.
TEST(Range, NoEventIsLostAtEitherEnd) {
  std::mt19937 random(10);
  int seen = 0;
  int said = 0;
  for (int n = 0; n < 600; ++n) {
    const bool is_float = n % 2 == 0;
    std::uniform_int_distribution<int> exponent(is_float ? -46 : -324, is_float ? 40 : 308);
    const auto power = [&](bool vary) { return vary ? std::pow(10., exponent(random)) : 1.; };
    const double length = power(n % 3 != 0), speed = power(n % 5 != 0), mass = power(n % 7 == 0);
    if (!(length > 0) || !(speed > 0) || !(mass > 0) || !std::isfinite(4 * length) || !(length / speed > 0) ||
        !std::isfinite(100 * length / speed))
      continue;
    const Timing timing = n % 4 == 0 ? Timing::paper : n % 4 == 1 ? Timing::certified : Timing::stable;
    const Ending run =
        ending_of(approaching(length, speed, mass, n % 2 == 1), is_float ? "float" : "double", timing);
    EXPECT_EQ(run.bytes.find("nan"), std::string::npos) << n;
    const bool tells = run.end == "refused" || run.end == "out_of_range";
    EXPECT_TRUE(tells || run.events > 0) << n << ' ' << length << ' ' << speed << ' ' << run.end;
    (tells ? said : seen) += 1;
  }
  EXPECT_GE(seen, 50);
  EXPECT_GE(said, 50);
}

TEST(Range, TheEndIsThatOfTheStepBefore) {
  Scene scene = testing::plain_scene();
  scene.duration = 10;
  const int light = testing::add_species(scene, "light", 1e-9, .5);
  testing::block(scene, 0, 0, 1);
  add_particle(scene, 0, {0, 0, 0}, {1, 0, 0});
  add_particle(scene, 0, {2, 0, 0});
  add_particle(scene, light, {0, 9, 0});
  ScheduledImpulse impulse;
  impulse.at = 3;
  impulse.particle = 2;
  impulse.impulse = {1e30, 0, 0};  // a velocity of 1e39, which float does not have
  scene.impulses = {impulse};
  const testing::TracedRun run = testing::traced(scene, "float");
  EXPECT_EQ(run.summary.end, "out_of_range");
  EXPECT_NE(run.summary.out_of_range, "");
  EXPECT_EQ(run.summary.events, 1U);
  EXPECT_EQ(run.events.size(), 1U);
  EXPECT_NE(run.lines.back().find("\"end\":\"out_of_range\""), std::string::npos);
  EXPECT_EQ(run.bytes.find("nan"), std::string::npos);
  EXPECT_EQ(run_scene(scene, {}).end, "duration");
}

TEST(Range, PointsThatFallTogetherEndTheRun) {
  Scene scene = testing::plain_scene();
  scene.duration = 10;
  testing::tether(scene, 0, 0, 2, 1);
  scene.tethers = {{0, 1}};
  add_particle(scene, 0, {1e17, 0, 0});
  add_particle(scene, 0, {1e17, 0, 0}, {1, 0, 0});
  const testing::TracedRun run = testing::traced(scene, "double");
  EXPECT_EQ(run.summary.end, "out_of_range");
  EXPECT_NE(run.summary.out_of_range.find("particles 0 and 1"), std::string::npos);
  EXPECT_EQ(run.summary.events, 0U);
  EXPECT_EQ(run.bytes.find("nan"), std::string::npos);
}

// Cells ask a pair again when they look for the next event, behind the step that all pairs asked it in.
TEST(Range, EveryDetectorLeavesItAtTheSameEvent) {
  const Scene scene = read_scene_text(
      R"({"tps":1,"dimension":2,"duration":8,"species":{"a":{"mass":2.3283064365386963e-10,"radius":0.5},)"
      R"("b":{"mass":34359738368,"radius":0.5}},"pairs":[{"between":["a","a"],"blocking":{"distance":1,"c_rebound":0}},)"
      R"({"between":["a","b"],"blocking":{"distance":1,"c_rebound":0}},{"between":["b","b"],"blocking":{"distance":1,"c_rebound":0}}],)"
      R"("particles":[{"id":0,"species":"b","position":[-4,0],"velocity":[-2,0]},{"id":1,"species":"b","position":[4,0],"velocity":[-2,0]},)"
      R"({"id":2,"species":"b","position":[-1,0],"velocity":[-1,-2]},{"id":3,"species":"a","position":[1,3],"velocity":[-1,-1]},)"
      R"({"id":4,"species":"a","position":[3,0],"velocity":[0,0]}]})",
      "scene");
  RunOptions options = testing::options_for("float");
  options.timing = Timing::paper;
  std::set<std::string> traces;
  for (const DetectorKind detector : {DetectorKind::all_pairs, DetectorKind::cells}) {
    options.detector = detector;
    const testing::TracedRun run = testing::traced(scene, options);
    EXPECT_EQ(run.summary.end, "out_of_range");
    EXPECT_EQ(run.summary.events, 2U);
    traces.insert(run.bytes);
  }
  EXPECT_EQ(traces.size(), 1U);
}

TEST(Range, AStartIsJudgedInTheScalarOfTheRun) {
  Scene scene = testing::plain_scene();
  scene.duration = 3;
  testing::block(scene, 0, 0, 1);
  add_particle(scene, 0, {16777217.4, 0, 0}, {1, 0, 0});
  add_particle(scene, 0, {16777218.45, 0, 0}, {-1, 0, 0});
  try {
    run_scene(scene, testing::options_for("float"));
    ADD_FAILURE() << "both are at 16777218 in float";
  } catch (const InputError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("particles 0 and 1"), std::string::npos) << text;
    EXPECT_NE(text.find("16777217.4"), std::string::npos) << text;
  }
  EXPECT_EQ(run_scene(scene, {}).events, 1U);
}

}  // namespace
}  // namespace tps
