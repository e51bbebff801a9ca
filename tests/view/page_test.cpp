// The page of a trace: whole, self-contained, and safe whatever the names in a file are.
#include "verify/view/page.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <nlohmann/json.hpp>

#include "reference/scene/read_scene.hpp"
#include "tests/run/traced_run.hpp"
#include "tests/support/shell.hpp"
#include "verify/trace_check/check.hpp"
#include "verify/view/base64.hpp"
#include "verify/view/columns.hpp"
#include "verify/view/viewer_files.hpp"

namespace tps::view {
namespace {

using testing::options_for;
using testing::scratch;
using testing::traced;
using testing::traced_bytes;
using testing::write_bytes;

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

/// The page without the files of the viewer, which are not of the trace.
std::string without_viewer(std::string text) {
  for (const ViewerFile& file : viewer_files()) {
    const std::size_t at = text.find(file.text);
    EXPECT_NE(at, std::string::npos) << file.name;
    if (at != std::string::npos) text.erase(at, file.text.size());
  }
  return text;
}

std::string between(const std::string& text, const std::string& begin, const std::string& end) {
  const std::size_t from = text.find(begin) + begin.size();
  return text.substr(from, text.find(end, from) - from);
}

const std::string kHostile =
    "</script><script>alert(1)</script><img src=x onerror=alert(2)>&quot;\"'\u202e<!--";

TEST(Page, NamesAreDataNeverMarkup) {
  require_viewer();
  Scene scene = testing::plain_scene();
  scene.title = kHostile;
  scene.species[0].name = kHostile;
  testing::add_particle(scene, 0, {0, 0, 0});
  Playback playback = start_of(scene);
  playback.notes = {kHostile};
  ShownFinding finding;
  finding.finding.message = finding.finding.reading = kHostile;
  const std::string mine = without_viewer(page(playback, {finding}));
  const std::string harmless = without_viewer(page(start_of(testing::plain_scene()), {}));
  for (const char* markup : {"<script", "</script", "<img", "<!--", "<style", "\u202e"})
    EXPECT_EQ(count(mine, markup), count(harmless, markup)) << markup;
  // And yet all of it is there.
  const auto what = nlohmann::json::parse(between(mine, "id=\"what\">", "</script>"));
  EXPECT_NE(what["title"].get<std::string>().find("<img src=x"), std::string::npos);
  EXPECT_EQ(what["species"][0]["name"], what["title"]);
  EXPECT_EQ(what["findings"][0]["message"], what["title"]);
}

TEST(Page, LoadsNothingAndAllowsNothing) {
  require_viewer();
  const std::string text = without_viewer(page(start_of(testing::plain_scene()), {}));
  EXPECT_EQ(count(text, "<link"), 0U);
  EXPECT_EQ(count(text, " src="), 0U);
  EXPECT_EQ(count(text, "http"), 1U) << "http-equiv and no address";
  EXPECT_NE(text.find("default-src 'none'"), std::string::npos);
  EXPECT_EQ(count(text, "unsafe"), 0U);
  EXPECT_EQ(count(text, "'sha256-"), viewer_files().size());
}

TEST(Page, IsAFunctionOfTheTrace) {
  require_viewer();
  const Playback playback = start_of(read_scene_file(TPS_SOURCE_DIR "/data/scenes/pair.json"));
  EXPECT_EQ(page(playback, {}), page(playback, {}));
}

// RFC 4648, section 10.
TEST(Page, Base64) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foob"), "Zm9vYg==");
  EXPECT_EQ(base64("\xff\xfe\xfd"), "//79");
}

TEST(Page, ColumnsHoldTheNumbersBitByBit) {
  Scene scene = testing::plain_scene();
  testing::add_particle(scene, 0, {0.1, -0.0, 0}, {5e-324, 1e308, 0});
  const Columns columns(start_of(scene));
  const auto& place = columns.places()["particle_velocity"];
  EXPECT_EQ(place["length"], 2);
  double read[2];
  std::memcpy(read, columns.bytes().data() + place["from"].get<std::size_t>(), sizeof read);
  EXPECT_EQ(read[0], 5e-324);
  EXPECT_EQ(read[1], 1e308);
  for (const auto& column : columns.places()) EXPECT_EQ(column["from"].get<std::size_t>() % 8, 0U);
}

/// The trace of X, Y and Z with the sign of Δp turned at event 2.
std::string broken_trace() {
  std::string bytes =
      traced_bytes(read_scene_file(TPS_SOURCE_DIR "/data/scenes/three-body.json"), options_for("double"));
  const std::size_t event = bytes.find("{\"k\":2,"), dp = bytes.find("\"dp\":[\"-", event) + 7;
  bytes.erase(dp, 1);
  const std::string path = scratch("broken.ndjson");
  write_bytes(path, bytes);
  return path;
}

TEST(Page, FindingsComeWithWhatWasExpected) {
  const std::string path = broken_trace();
  const check::CheckReport report = check::check_trace(path);
  const Playback playback = read_playback(path);
  const std::vector<ShownFinding> shown = shown_findings(report, playback.scene);
  ASSERT_EQ(shown.size(), 3U);
  ASSERT_EQ(shown[0].expected.size(), 1U);
  EXPECT_EQ(shown[0].expected[0].of, "dp");
  EXPECT_EQ(shown[0].expected[0].particle, 1);
  EXPECT_EQ(playback.events[1].dp[0], -shown[0].expected[0].value[0]);
  // Eq. (3) with the Δp as it stands: the velocity of 1 before the event, and Δp over its mass of 0.001.
  EXPECT_EQ(shown[1].expected[0].of, "velocity");
  EXPECT_NEAR(shown[1].expected[0].value[0], 5.99001398, 1e-8);
  EXPECT_EQ(lines_of(report), (std::vector<std::uint64_t>{4, 4, 4}));
}

TEST(ViewVerb, WritesAPageOfATraceAndOfAScene) {
  const std::string trace = broken_trace(), html = scratch("page.html");
  EXPECT_EQ(run_shell(TPS_PROGRAM " view " + trace + " -o " + html).exit_code, 0);
  EXPECT_TRUE(testing::read_bytes(html).starts_with("<!DOCTYPE html>"));
  const Outcome scene =
      run_shell(TPS_PROGRAM " view " TPS_SOURCE_DIR "/data/scenes/three-body.json -q -o " + html);
  EXPECT_EQ(scene.exit_code, 0) << scene.text;
  const std::string what = between(testing::read_bytes(html), "id=\"what\">", "</script>");
  EXPECT_EQ(nlohmann::json::parse(what)["all_events"], 70);
}

TEST(ViewVerb, ChecksWithAPage) {
  const std::string trace = broken_trace(), html = scratch("checked.html");
  EXPECT_EQ(run_shell(TPS_PROGRAM " check " + trace + " -q --view " + html).exit_code, 1);
  const std::string what = between(testing::read_bytes(html), "id=\"what\">", "</script>");
  EXPECT_EQ(nlohmann::json::parse(what)["findings"].size(), 3U);
}

TEST(ViewVerb, RefusesWhatItCannotPlay) {
  EXPECT_EQ(run_shell(TPS_PROGRAM " view nowhere.ndjson").exit_code, 3);
  EXPECT_EQ(run_shell(TPS_PROGRAM " view " TPS_SOURCE_DIR "/data/schemas/scene.schema.json").exit_code, 3);
  const Outcome piped = run_shell("cat " + broken_trace() + " | " TPS_PROGRAM " check - --view page.html");
  EXPECT_EQ(piped.exit_code, 2);
  EXPECT_NE(piped.text.find("name a file"), std::string::npos) << piped.text;
  const std::string trace = broken_trace();
  EXPECT_EQ(run_shell(TPS_PROGRAM " view " + trace + " -o " + trace).exit_code, 2);
}

}  // namespace
}  // namespace tps::view
