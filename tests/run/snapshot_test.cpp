// A snapshot of a run with drag, whose states are on the clock s: it is chosen, and told, by the time since
// the start.
#include "reference/run/snapshot.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <optional>

#include "reference/scene/read_scene.hpp"
#include "tests/run/traced_run.hpp"

namespace tps {
namespace {

constexpr double kStart = 64;

double number(const nlohmann::json& text) {
  return std::strtod(text.get<std::string>().c_str(), nullptr);
}

double time(const nlohmann::json& hi_and_lo) {
  return number(hi_and_lo[0]) + number(hi_and_lo[1]);
}

/// The states of a trace, in their order.
std::vector<nlohmann::json> states_of(const testing::TracedRun& run) {
  std::vector<nlohmann::json> states;
  for (const std::string& line : run.lines) {
    nlohmann::json json = nlohmann::json::parse(line);
    if (json.contains("now")) states.push_back(std::move(json));
  }
  return states;
}

class SnapshotUnderDrag : public ::testing::TestWithParam<const char*> {};

TEST_P(SnapshotUnderDrag, IsOfTheTimeSinceTheStart) {
  Scene scene = read_scene_file(TPS_SOURCE_DIR "/data/scenes/gas-drag.json");
  scene.start_time = kStart;
  RunOptions options = testing::options_for(GetParam());
  options.state_every = 5;
  const testing::TracedRun run = testing::traced(scene, options);
  const std::string path = testing::scratch("snapshot.ndjson");
  testing::write_bytes(path, run.bytes);
  const std::vector<nlohmann::json> states = states_of(run);
  ASSERT_GT(states.size(), 4U);
  double last = -1;
  for (const nlohmann::json& state : states) {
    const double t = number(state["t"]) - kStart;  // the label is a double of 64 or more: to 2^-47
    const double s = time(state["now"]);
    if (t == last) continue;  // the last state of a time is the one that is found
    last = t;
    const Snapshot at_once = read_snapshot(path, t + 0x1p-40);
    EXPECT_NEAR(at_once.t, t, 0x1p-46);
    EXPECT_TRUE(s == 0 || at_once.t > s);
    const nlohmann::json& p = state["particles"][1];
    const double flight = s - time(p["clock"]);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(at_once.positions[1][k], number(p["position"][k]) + number(p["velocity"][k]) * flight,
                  1e-12);
    }
  }
  EXPECT_GT(last, 1.5);
}

INSTANTIATE_TEST_SUITE_P(Scalars, SnapshotUnderDrag, ::testing::Values("float", "double", "mp50"));

}  // namespace
}  // namespace tps
