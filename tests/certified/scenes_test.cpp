// Whole scenes under certified timing end as they do under stable timing; the program's side of it.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "reference/scene/read_scene.hpp"
#include "reference/scene/write_scene.hpp"
#include "tests/run/traced_run.hpp"
#include "verify/certified/exact_timing.hpp"
#include "verify/scenes/galperin.hpp"
#include "verify/scenes/three_body.hpp"
#include "verify/scenes/two_anchors.hpp"

namespace tps {
namespace {

RunSummary certified_run(const Scene& scene, const std::string& scalar = "double",
                         std::optional<std::uint64_t> max_events = {}) {
  certified::ExactTiming certifier;
  RunOptions options = testing::options_for(scalar, max_events);
  options.timing = Timing::certified;
  options.certifier = &certifier;
  return run_scene(scene, options);
}

TEST(CertifiedScenes, KnownCountsAndEnds) {
  const std::vector<std::uint64_t> pi = {3, 31, 314};
  for (const char* scalar : {"double", "float"}) {
    for (int digits = 0; digits < (scalar[0] == 'd' ? 3 : 2); ++digits) {
      const RunSummary s = certified_run(build_galperin({.digits = digits}), scalar);
      EXPECT_EQ(s.end, "no_more_events");
      EXPECT_EQ(s.events, pi[static_cast<std::size_t>(digits)]) << scalar;
    }
  }
  const RunSummary three_body = certified_run(build_three_body({}));
  EXPECT_EQ(three_body.end, "no_more_events");
  EXPECT_EQ(three_body.events, 70U);
  const RunSummary anchors = certified_run(build_two_anchors({}));
  EXPECT_EQ(anchors.end, "stalled");
  EXPECT_EQ(anchors.t, 0);
}

TEST(CertifiedScenes, EveryShippedSceneRunsWithinItsBounds) {
  int scenes = 0;
  for (const auto& file : std::filesystem::directory_iterator(TPS_SOURCE_DIR "/data/scenes")) {
    const Scene scene = read_scene_file(file.path().string());
    for (const char* scalar : {"double", "float"}) {
      const RunSummary s = certified_run(scene, scalar, 150);
      const std::string what = file.path().stem().string() + " " + scalar;
      EXPECT_GT(s.events, 0U) << what;
      EXPECT_LE(std::abs(s.energy_remainder), s.energy_bound) << what;
      EXPECT_LE(s.momentum_drift, s.momentum_bound) << what;
      ASSERT_TRUE(s.certified);
      EXPECT_GT(s.certified->time.calls, 0U) << what;
      EXPECT_LE(s.certified->verdict.exact, s.certified->verdict.uncertain) << what;
    }
    ++scenes;
  }
  EXPECT_GE(scenes, 14);
}

struct Outcome {
  int code;
  std::string out, err;
};

Outcome tps(const std::string& arguments) {
  const std::string out = testing::scratch("stdout");
  const std::string err = testing::scratch("stderr");
  const std::string command = "'" TPS_PROGRAM "' " + arguments + " >'" + out + "' 2>'" + err + "'";
  const int status = std::system(command.c_str());
  return {WEXITSTATUS(status), testing::read_bytes(out), testing::read_bytes(err)};
}

std::string three_body_file() {
  const std::string path = testing::scratch("scene.json");
  testing::write_bytes(path, write_scene(build_three_body({}), SceneStyle::pretty));
  return path;
}

TEST(CertifiedProgram, OtherScalarsAreRefused) {
  const std::string scene = three_body_file();
  for (const char* scalar : {"long-double", "quad", "mp50", "mp100"}) {
    const Outcome o = tps("run '" + scene + "' --timing certified --scalar " + scalar);
    EXPECT_EQ(o.code, 2);
    EXPECT_NE(o.err.find(scalar), std::string::npos) << o.err;
    EXPECT_NE(o.err.find("float or double"), std::string::npos) << o.err;
  }
  EXPECT_EQ(tps("run '" + scene + "' --timing exact").code, 2);
}

TEST(CertifiedProgram, CountersAreShownForCertifiedTimingOnly) {
  const std::string scene = three_body_file();
  const Outcome text = tps("run '" + scene + "' -q --timing certified");
  EXPECT_EQ(text.code, 0);
  for (const char* part : {"certified  verdicts: ", "times: ", "orders: ", " by integers"}) {
    EXPECT_NE(text.out.find(part), std::string::npos) << text.out;
  }
  const Outcome json = tps("run '" + scene + "' -q --timing certified --format json");
  const nlohmann::json counters = nlohmann::json::parse(json.out).at("certified");
  for (const char* question : {"verdict", "time", "order"}) {
    const nlohmann::json& stages = counters.at(question);
    EXPECT_LE(stages.at("exact"), stages.at("uncertain"));
    EXPECT_LE(stages.at("uncertain"), stages.at("calls"));
  }
  EXPECT_GT(counters.at("time").at("calls"), 0);
  EXPECT_TRUE(counters.contains("largest_bits"));
  for (const char* timing : {"paper", "stable"}) {
    EXPECT_EQ(tps("run '" + scene + "' -q --timing " + timing).out.find("certified"), std::string::npos);
    const Outcome other = tps("run '" + scene + "' -q --format json --timing " + timing);
    EXPECT_FALSE(nlohmann::json::parse(other.out).contains("certified"));
  }
}

TEST(CertifiedProgram, TheTraceNamesTheTimingAndResumeKeepsIt) {
  const std::string scene = three_body_file();
  const std::string trace = testing::scratch("trace.ndjson");
  for (const char* timing : {"paper", "stable", "certified"}) {
    const std::string run = "run '" + scene + "' -q --state-every 7 --timing " + timing + " -o ";
    const std::string whole = tps(run + "-").out;
    EXPECT_NE(whole.find("\"options\":{\"timing\":\"" + std::string(timing) + "\""), std::string::npos);
    EXPECT_EQ(tps(run + "'" + trace + "' --max-events 33").code, 0);
    EXPECT_EQ(tps("run -q --resume '" + trace + "'").code, 0);
    EXPECT_EQ(testing::read_bytes(trace), whole);
  }
  EXPECT_EQ(tps("run -q --timing stable --resume '" + trace + "'").code, 2);
}

TEST(CertifiedProgram, AHeaderWithATimingThatCannotBeIsBadInput) {
  const std::string scene = three_body_file();
  const std::string trace = testing::scratch("trace.ndjson");
  tps("run '" + scene + "' -q --max-events 9 -o '" + trace + "'");
  const std::string good = testing::read_bytes(trace);
  const auto with = [&](const std::string& old_text, const std::string& new_text) {
    std::string bytes = good;
    bytes.replace(bytes.find(old_text), old_text.size(), new_text);
    testing::write_bytes(trace, bytes);
    return tps("run -q --resume '" + trace + "'");
  };
  const Outcome unknown = with("\"stable\"", "\"exact\"");
  EXPECT_EQ(unknown.code, 3);
  EXPECT_NE(unknown.err.find("\"exact\""), std::string::npos) << unknown.err;
  EXPECT_EQ(with("\"stable\"", "7").code, 3);
  EXPECT_EQ(with("\"timing\":\"stable\",", "").code, 0) << "a trace from before says nothing: stable";
  const Outcome wide =
      with("\"double\",\"options\":{\"timing\":\"stable\"", "\"quad\",\"options\":{\"timing\":\"certified\"");
  EXPECT_EQ(wide.code, 3);
  EXPECT_NE(wide.err.find("certified"), std::string::npos) << wide.err;
}

TEST(CertifiedProgram, ACheckpointOfAnotherTimingIsRefused) {
  const std::string scene = three_body_file();
  const std::string trace = testing::scratch("trace.ndjson");
  const std::string checkpoint = testing::scratch("checkpoint.json");
  tps("run '" + scene + "' -q --state-every 7 --max-events 21 --timing certified --checkpoint '" +
      checkpoint + "'");
  tps("run '" + scene + "' -q --state-every 7 --max-events 21 -o '" + trace + "'");
  const Outcome o = tps("run -q --resume '" + checkpoint + "' -o '" + trace + "'");
  EXPECT_EQ(o.code, 3);
  EXPECT_NE(o.err.find("timing"), std::string::npos) << o.err;
}

}  // namespace
}  // namespace tps
