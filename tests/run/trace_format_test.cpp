// What docs/trace.md and data/schemas/trace.schema.json say of a trace is what a run writes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>

#include "tests/run/traced_run.hpp"
#include "verify/scenes/galperin.hpp"
#include "verify/scenes/pair.hpp"
#include "verify/scenes/ring.hpp"
#include "verify/scenes/terminal.hpp"
#include "verify/scenes/two_anchors.hpp"

namespace tps {
namespace {

using testing::options_for;
using testing::scratch;
using testing::traced;
using testing::TracedRun;

int validate(const std::string& path) {
  const std::string command = std::string("'" TPS_PYTHON3 "' '" TPS_SOURCE_DIR) +
                              "/tests/run/validate_trace.py' '" TPS_SOURCE_DIR +
                              "/data/schemas/trace.schema.json' '" + path + "' 2>&1";
  return std::system(command.c_str());
}

TEST(TraceSchema, AcceptsWhatRunsWrite) {
  Scene terminal = build_terminal({.vesicles = 6,
                                   .pairs = 12,
                                   .membrane_radius = 12,
                                   .form_probability = .5,
                                   .impact_at = .1,
                                   .grouped = .01,
                                   .duration = 1});
  const auto rules = std::find_if(terminal.pairs.begin(), terminal.pairs.end(), [](const PairLaw& law) {
    return law.tethering && law.tethering->form.when != FormRule::When::permanent;
  });
  terminal.phases = {{.from = .1,
                      .until = .5,
                      .species_a = rules->species_a,
                      .species_b = rules->species_b,
                      .form = {},
                      .breaks = BreakRule{.when = BreakRule::When::always}}};
  Scene breaking = build_pair({});
  breaking.pairs[0].tethering->breaks.when = BreakRule::When::always;
  std::string kinds;
  for (const Scene& scene :
       {terminal, breaking, build_ring({}), build_pair({}), build_two_anchors({.grouped = .01})}) {
    for (const auto& [scalar, events] : {std::pair("double", 300), std::pair("mp50", 60)}) {
      RunOptions options = options_for(scalar, static_cast<std::uint64_t>(events));
      options.state_every = 5;
      const TracedRun run = traced(scene, options);
      EXPECT_EQ(validate(scratch("trace.ndjson")), 0) << scene.title << ' ' << scalar;
      kinds += run.bytes;
    }
  }
  for (const char* kind : {"rebound", "retract", "revolve", "break", "restitute", "scheduled_impulse",
                           "phase_begin", "phase_end"}) {
    EXPECT_NE(kinds.find(std::string("\"kind\":\"") + kind + "\""), std::string::npos) << kind;
  }
}

TEST(TraceSchema, RefusesWhatIsNoTrace) {
  const std::string path = scratch("bad.ndjson");
  for (
      const char* line :
      {"{}", R"({"end":"tired","events":1,"t":"0x0p+0"})", R"({"end":"duration","events":1,"t":0.5})",
       R"({"k":1,"t":"0x1p+0","dt":"0x1p+0","kind":"rebound"})",
       R"({"k":0,"t":"0x1p+0","dt":"0x1p+0","kind":"phase_begin","phase":0})",
       R"({"trace":1,"checkpoint":1,"semantics":1,"version":"1","scalar":"double","options":{"state_every":1},"scene":{"tps":1}})"}) {
    testing::write_bytes(path, std::string(line) + "\n");
    EXPECT_NE(validate(path), 0) << line;
  }
}

TEST(TraceFormat, HasTheLinesThatItsPageShows) {
  const TracedRun run = traced(build_galperin({.digits = 0}), "double");
  std::istringstream page(testing::read_bytes(TPS_SOURCE_DIR "/docs/trace.md"));
  int shown = 0;
  for (std::string line; std::getline(page, line);) {
    if (!line.starts_with("{\"")) continue;
    const std::string start = line.substr(0, line.find("…"));
    const bool whole = start.size() == line.size();
    EXPECT_TRUE(std::any_of(run.lines.begin(), run.lines.end(), [&](const std::string& l) {
      return whole ? l == line : l.starts_with(start);
    })) << line;
    ++shown;
  }
  EXPECT_GE(shown, 4);
}

TEST(TraceFormat, EveryEventFollowsTheOneBeforeAndStatesComeInTime) {
  RunOptions options = options_for("double", 100);
  options.state_every = 10;
  const TracedRun run = traced(build_ring({}), options);
  std::uint64_t k = 0;
  int states = 0;
  for (const std::string& line : run.lines) {
    if (line.starts_with("{\"k\":")) {
      EXPECT_TRUE(line.starts_with("{\"k\":" + std::to_string(++k) + ","));
    }
    if (line.starts_with("{\"state\":")) {
      EXPECT_TRUE(line.starts_with("{\"state\":" + std::to_string(k) + ","));
      ++states;
    }
  }
  EXPECT_EQ(k, run.events.size());
  EXPECT_GE(states, 5);
  EXPECT_TRUE(run.lines.front().starts_with("{\"trace\":1,"));
  EXPECT_TRUE(run.lines.back().starts_with("{\"end\":\"max_events\",\"events\":" + std::to_string(k) + ","));
}

}  // namespace
}  // namespace tps
