// Traces that hold no more than velocities.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "tests/trace_check/check_command.hpp"

namespace tps {
namespace {

using nlohmann::json;

/// The trace of velocities only: what docs/check.md shows, from the full one.
std::string minimal_of(const std::string& full) {
  std::istringstream lines(full);
  std::string line, text;
  while (std::getline(lines, line)) {
    json event = json::parse(line);
    if (event.contains("trace")) {
      text += json{{"trace", 1}, {"form", "minimal"}, {"scalar", event["scalar"]}, {"scene", event["scene"]}}
                  .dump() +
              "\n";
    } else if (event.contains("end")) {
      text += line + "\n";
    } else if (event.contains("kind")) {
      json small{{"t", event["t"]}, {"kind", event["kind"]}};
      for (const char* key : {"i", "j", "tether", "phase"}) {
        if (event.contains(key)) small[key] = event[key];
      }
      if (event.contains("post")) {
        for (auto& [id, state] : event["post"].items()) small["post"][id]["velocity"] = state["velocity"];
      }
      text += small.dump() + "\n";
    }
  }
  return text;
}

/// Every time off by half of the last place.
std::string with_other_times(const std::string& minimal) {
  std::istringstream lines(minimal);
  std::string line, text;
  while (std::getline(lines, line)) {
    json event = json::parse(line);
    if (event.contains("kind")) {
      const double t = std::strtod(event["t"].get<std::string>().c_str(), nullptr);
      event["t"] = std::nextafter(t, 2 * t);
    }
    text += event.dump() + "\n";
  }
  return text;
}

using CertifiedMinimal = Check;

TEST_F(CertifiedMinimal, IsToldWhatItsHeaderPromises) {
  run_shell(kTps + " run " TPS_SOURCE_DIR "/data/scenes/gas.json -q --timing certified --max-events 40 -o " +
            file("full") + " > /dev/null");
  const std::string rounded = with_other_times(minimal_of(content(file("full"))));
  write("stable", rounded);
  const Outcome taken = check(file("stable"));
  EXPECT_EQ(taken.exit_code, 0) << taken.text;
  EXPECT_EQ(taken.text.find("promises certified timing"), std::string::npos);
  write("certified", R"({"options":{"timing":"certified"},)" + rounded.substr(1));
  const Outcome promised = check(file("certified"));
  EXPECT_EQ(promised.exit_code, 1);
  expect_text(promised, R"(who writes t rounded once leaves "options" out of the header)");
}

/// Named like a scene of data/scenes, with _ for -.
class Minimal : public Check, public testing::WithParamInterface<const char*> {
 protected:
  static std::string scene_file() {
    std::string name = GetParam();
    std::replace(name.begin(), name.end(), '_', '-');
    return name;
  }
};

TEST_P(Minimal, VelocitiesAreEnoughForAReducedCheck) {
  run_shell(kTps + " run " TPS_SOURCE_DIR "/data/scenes/" + scene_file() + ".json -q --max-events 300 -o " +
            file("full") + " > /dev/null");
  const std::string text = minimal_of(content(file("full")));
  write("minimal", text);
  const Outcome valid = run_shell("python3 " TPS_SOURCE_DIR "/tests/run/validate_trace.py " TPS_SOURCE_DIR
                                  "/data/schemas/minimal_trace.schema.json " +
                                  file("minimal"));
  EXPECT_EQ(valid.exit_code, 0) << valid.text;
  const Outcome outcome = check(file("minimal"));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.text;
  expect_text(outcome, "not judged states: a minimal trace has no full states to judge");
  // The third event left out: its particles come with other velocities than they were left with.
  std::size_t begin = 0;
  for (int n = 0; n < 3; ++n) begin = text.find('\n', begin) + 1;
  const std::size_t end = text.find('\n', begin) + 1;
  write("dropped", text.substr(0, begin) + text.substr(end));
  EXPECT_EQ(check(file("dropped")).exit_code, 1);
}

INSTANTIATE_TEST_SUITE_P(Scenes, Minimal,
                         testing::Values("three_body", "pair", "gas", "sheet", "terminal",
                                         "three_body_grouped"),
                         [](const auto& tested) { return std::string(tested.param); });

}  // namespace
}  // namespace tps
