// The check and the periodic box: honest runs conform in every scalar and timing; who misses a partner across
// an edge, or meets where no image is, is told.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "reference/text/hexfloat.hpp"
#include "tests/run/resumed_run.hpp"
#include "tests/run/traced_run.hpp"
#include "tests/trace_check/checked_trace.hpp"
#include "verify/certified/exact_timing.hpp"
#include "verify/trace_check/check.hpp"

namespace tps {
namespace periodic_boxes_in_traces {

using nlohmann::json;
using testing::checked;
using testing::first_finding;
using testing::violated;

/// Balls that are tethered by their collisions at times, in a box that is periodic in x and y, in space
/// between two walls; two of them alone in the plane; rough ones of seed 7, with drag of seed 8.
Scene boxed(unsigned seed) {
  Scene scene = testing::plain_scene(2 + static_cast<int>(seed % 2));
  scene.seed = seed;
  scene.duration = 30;
  const double open = std::numeric_limits<double>::infinity();
  scene.box = PeriodicEdges{{5.5, 4.25, open}};
  testing::block(scene, 0, 0, seed % 3 == 0 ? .9 : 1);
  testing::tether(scene, 0, 0, 1.6, .7, FormRule::When::always).tethering->breaks.when =
      BreakRule::When::always;
  if (seed % 4 == 1) scene.grouping = Grouping{.02};
  if (seed == 7) scene.pairs[0].friction = FrictionLaw{.3, .2};
  if (seed == 8) scene.drag = Drag{.02};
  if (scene.dimension == 3 && !scene.grouping) {
    Wall floor;
    floor.normal = {0, 0, 1};
    Wall ceiling;
    ceiling.point = {0, 0, 2.5};
    ceiling.normal = {0, 0, -1};
    scene.walls = {floor, ceiling};
  }
  const int count = seed % 5 == 2 ? 2 : 6;
  for (int n = 0; n < count; ++n) {
    const double side = n % 2 == 0 ? 1 : -1;
    testing::add_particle(scene, 0, {.3 + 1.7 * (n % 3), .4 + 1.9 * (n / 3), 1.2},
                          {.8 * side, .3 - .25 * n, scene.dimension == 3 ? .2 * side : 0});
  }
  if (scene.dimension == 2) {
    for (Particle& particle : scene.particles) particle.position[2] = 0;
  }
  return scene;
}

testing::TracedRun honest(const Scene& scene, const std::string& scalar, Timing timing) {
  certified::ExactTiming certifier;
  RunOptions options = testing::options_for(scalar, 150);
  options.timing = timing;
  options.certifier = &certifier;
  return testing::traced(scene, options);
}

TEST(CheckOfPeriodicBox, HonestRunsConform) {
  std::uint64_t events = 0;
  for (unsigned seed = 1; seed <= 8; ++seed) {
    for (const char* scalar : {"float", "double", "long-double", "quad"}) {
      const bool certifiable = scalar == std::string("float") || scalar == std::string("double");
      if (!certifiable && seed > 1) continue;
      for (const Timing timing : {Timing::stable, Timing::paper, Timing::certified}) {
        if (timing == Timing::certified && !certifiable) continue;
        const testing::TracedRun run = honest(boxed(seed), scalar, timing);
        events += run.events.size();
        const check::CheckReport report = checked(run.bytes);
        ASSERT_TRUE(report.conforming())
            << seed << ' ' << scalar << ' ' << static_cast<int>(timing) << ": " << first_finding(report);
        EXPECT_LE(std::abs(run.summary.energy_remainder), run.summary.energy_bound) << seed << ' ' << scalar;
        EXPECT_LE(run.summary.momentum_drift, run.summary.momentum_bound) << seed << ' ' << scalar;
      }
    }
  }
  EXPECT_GE(events, 500U);
}

bool is_across(const json& event, double edge) {
  std::vector<double> x;
  for (const json& state : event["pre"])
    x.push_back(std::strtod(state["position"][0].get<std::string>().c_str(), nullptr));
  return x.size() == 2 && std::fabs(x[0] - x[1]) > edge / 2;
}

// A rebound across an edge that is left out is missed; one in a box that is a bit wider is none.
TEST(CheckOfPeriodicBox, LiesAreTold) {
  for (const Timing timing : {Timing::stable, Timing::certified}) {
    const testing::TracedRun run = honest(boxed(4), "double", timing);
    std::string bytes;
    int across = 0;
    for (const std::string& line : run.lines) {
      const json event = json::parse(line);
      if (event.value("kind", "") == "rebound" && is_across(event, 5.5) && across++ == 1) continue;
      bytes += line + "\n";
    }
    ASSERT_GE(across, 2);
    EXPECT_GT(violated(checked(bytes), check::Rule::earliest), 0U);
    json head = json::parse(run.lines[0]);
    head.erase("checksum");
    head["scene"]["box"]["periodic"][0] = 5.5 + 1e-9;
    bytes = head.dump() + "\n";
    for (std::size_t n = 1; n < run.lines.size(); ++n) bytes += run.lines[n] + "\n";
    EXPECT_GT(violated(checked(bytes), check::Rule::contact), 0U);
    head["scene"].erase("box");
    bytes.replace(0, bytes.find('\n'), head.dump());
    EXPECT_GT(violated(checked(bytes), check::Rule::contact), 0U);
  }
}

TEST(CheckOfPeriodicBox, AResumedRunGoesOnToTheSameBytes) {
  for (const Timing timing : {Timing::stable, Timing::certified}) {
    certified::ExactTiming certifier;
    RunOptions options = testing::options_for("double", 120);
    options.state_every = 7;
    options.timing = timing;
    options.certifier = &certifier;
    testing::expect_same_when_resumed(boxed(6), options);
  }
}

}  // namespace periodic_boxes_in_traces
}  // namespace tps
