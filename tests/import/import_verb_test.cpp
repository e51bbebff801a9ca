// tps import as a program: exit codes, standard input and output, and runs of what it writes.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/shell.hpp"

namespace {

using tps::Outcome;
using tps::run_shell;

const std::string kTps = TPS_PROGRAM;
const std::string kData = TPS_SOURCE_DIR "/tests/import/data/";
const std::string kThree = kData + "three_bodies.json";
const std::string kFour = kData + "four_bodies.json";

struct Event {
  std::string t;
  int i, j;
  bool operator==(const Event&) const = default;
};

std::ostream& operator<<(std::ostream& out, const Event& event) {
  return out << event.t << ' ' << event.i << '-' << event.j;
}

/// The rebounds of a run of what `tps import ARGUMENTS` writes.
std::vector<Event> rebounds(const std::string& arguments, const std::string& run_options = "") {
  const Outcome outcome = run_shell(kTps + " import " + arguments + " 2>/dev/null | " + kTps +
                                    " run - -q -o - " + run_options + " 2>/dev/null");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.text;
  std::vector<Event> events;
  std::istringstream lines(outcome.text);
  for (std::string line; std::getline(lines, line);) {
    const nlohmann::json event = nlohmann::json::parse(line);
    if (event.value("kind", "") == "rebound") events.push_back({event["t"], event["i"], event["j"]});
  }
  return events;
}

// 1 stops at 2 and sends it on; 2 comes back from 10, three times as heavy, at half its speed, and meets 1
// again.
const std::vector<Event> kThreeRebounds{{"0x1p+1", 1, 2}, {"0x1p+2", 2, 10}, {"0x1p+3", 1, 2}};

TEST(ImportVerb, WhatItWritesRuns) {
  EXPECT_EQ(rebounds(kThree), kThreeRebounds);
  EXPECT_EQ(rebounds(kThree, "--scalar float"), kThreeRebounds);
}

TEST(ImportVerb, PointsPassThroughEachOther) {
  EXPECT_EQ(rebounds(kFour + " --without-random-impulses"), (std::vector<Event>{{"0x1.4p+1", 2, 4}}));
}

// With c = 0 both go on at 1/2: contact with 10 after 2 / (1/2), and with 1 again at once, which has stayed
// in contact.
TEST(ImportVerb, TheCoefficientIsThatOfTheOption) {
  const std::vector<Event> events = rebounds(kThree + " --c-rebound 0 --duration 6.5");
  ASSERT_GE(events.size(), 2U);
  EXPECT_EQ(events[0], (Event{"0x1p+1", 1, 2}));
  EXPECT_EQ(events[1], (Event{"0x1.8p+2", 2, 10}));
}

TEST(ImportVerb, ReadsStandardInputAndWritesFiles) {
  const std::string scene = run_shell(kTps + " import " + kThree + " 2>/dev/null").text;
  EXPECT_EQ(run_shell(kTps + " import - < " + kThree + " 2>/dev/null").text, scene);
  const std::string file = testing::TempDir() + "import_verb_writes.json";
  EXPECT_EQ(run_shell(kTps + " import " + kThree + " -o " + file + " 2>/dev/null && cat " + file).text,
            scene);
  EXPECT_EQ(nlohmann::json::parse(scene)["particles"][2]["id"], 10);
}

TEST(ImportVerb, NotesGoToStandardError) {
  const Outcome notes = run_shell(kTps + " import " + kFour + " --without-random-impulses 2>&1 >/dev/null");
  EXPECT_EQ(notes.exit_code, 0);
  EXPECT_EQ(notes.text.find("tps: note: config.ri is true; the scene has no random impulses, as asked\n"),
            0U);
}

struct Refused {
  std::string arguments;
  int exit_code;
  const char* says;
};

TEST(ImportVerb, SaysWhatIsWrong) {
  const Refused cases[] = {
      {kData, 3, "directory"},
      {kData + "none.json", 3, "none.json"},
      {"/dev/null", 3, "/dev/null"},
      {TPS_SOURCE_DIR "/README.md", 3, "README.md:1"},
      {TPS_SOURCE_DIR "/data/scenes/pair.json", 3, "pair.json: is a scene"},
      {"", 2, "file"},
      {kThree + " --c-rebound 1.5", 2, R"(--c-rebound is "1.5"; allowed is a number from 0 to 1)"},
      {kThree + " --c-rebound nan", 2, R"(--c-rebound is "nan"; allowed is a number from 0 to 1)"},
      {kThree + " --duration 0", 2, R"(--duration is "0"; allowed is a number above 0, or inf)"},
      {kThree + " --dt-restitute inf", 2, R"(--dt-restitute is "inf"; allowed is a number above 0 to)"},
      {kThree + " -o /none/scene.json", 7, "/none/scene.json"},
  };
  for (const Refused& refused : cases) {
    const Outcome outcome = run_shell(kTps + " import " + refused.arguments);
    EXPECT_EQ(outcome.exit_code, refused.exit_code) << refused.arguments << "\n" << outcome.text;
    EXPECT_NE(outcome.text.find(refused.says), std::string::npos) << refused.says << " is not in\n"
                                                                  << outcome.text;
  }
}

}  // namespace
