// Implementations that are not ours, through `tps properties`: right ones pass, a broken law is shrunk,
// printed and written down, and what is no answer is told apart.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <ostream>
#include <regex>
#include <string>

#include "tests/support/shell.hpp"

namespace tps::properties {
namespace {

using Process = tps::Outcome;

const std::string kPython = "/usr/bin/python3 " TPS_SOURCE_DIR "/tests/properties/implementation.py ";

/// A folder of the test's own.
class Foreign : public testing::Test {
 protected:
  Foreign() {
    std::string pattern = testing::TempDir() + "tps_properties_XXXXXX";
    folder_ = ::mkdtemp(pattern.data());
  }
  ~Foreign() override { std::filesystem::remove_all(folder_); }

  Process properties(const std::string& arguments) const {
    return run_shell("cd " + folder_ + " && " TPS_PROGRAM " properties --quiet " + arguments);
  }
  Process command(const std::string& mode, const std::string& arguments = "--cases 40") const {
    return properties(arguments + " -- " + kPython + mode);
  }
  std::string file(const std::string& name) const { return folder_ + "/" + name; }

 private:
  std::string folder_;
};

void expect_text(const Process& process, const std::string& text) {
  EXPECT_NE(process.text.find(text), std::string::npos) << text << "\nis not in\n" << process.text;
}

TEST_F(Foreign, ARightCommandPassesWhatItOffers) {
  const Process right = command("right");
  EXPECT_EQ(right.exit_code, 0) << right.text;
  expect_text(right, "(3) law 1              holds");
  expect_text(right, "(5) law 1              not offered");
  EXPECT_FALSE(std::filesystem::exists(file("broken-laws.jsonl")));
}

TEST_F(Foreign, ABrokenLawIsShrunkPrintedAndWrittenDown) {
  const Process wrong = command("half_rebound");
  EXPECT_EQ(wrong.exit_code, 1) << wrong.text;
  expect_text(wrong, "BROKEN (4) law 1: afterwards v_n' = −c v_n along û");
  expect_text(wrong, "Eq4Laws.Law1NormalVelocityTurnsByCAndTangentialStays, docs/eq4.md");
  expect_text(wrong, "c = 1, m_A = 1, m_B = 1, u_A = (0, 0), u_B = ");
  expect_text(wrong, "tps eval collision_impulse u_A=0,0 u_B=");
  expect_text(wrong, "known answers to the questions of broken laws: broken-laws.jsonl");

  const std::string known = file("broken-laws.jsonl");
  const Process proven = run_shell(TPS_PROGRAM " vectors verify " + known);
  EXPECT_EQ(proven.exit_code, 0) << proven.text;
  expect_text(proven, "cases proven again, 0 wrong");
  const auto judged = [&](const std::string& implementation) {
    return run_shell(TPS_PROGRAM " vectors requests " + known + " | " + implementation +
                     " | " TPS_PROGRAM " vectors verify " + known + " --answers -");
  };
  EXPECT_EQ(judged(kPython + "half_rebound").exit_code, 1);
  EXPECT_EQ(judged(kPython + "right").exit_code, 0);
  EXPECT_EQ(judged(TPS_PROGRAM " serve").exit_code, 0);
}

TEST_F(Foreign, ASignIsFound) {
  const Process wrong = command("sign", "--cases 40 --law 'Eq3Laws.*'");
  EXPECT_EQ(wrong.exit_code, 1) << wrong.text;
  expect_text(wrong, "BROKEN (3) law 1");
}

TEST_F(Foreign, BrokenCasesAreReplayed) {
  EXPECT_EQ(command("half_rebound", "--cases 40 --law 'Eq4*' --regressions cases.jsonl -o k.jsonl").exit_code,
            1);
  EXPECT_EQ(command("half_rebound", "--replay cases.jsonl").exit_code, 1);
  EXPECT_EQ(command("right", "--replay cases.jsonl").exit_code, 0);
  const Process reference = properties("--replay cases.jsonl --scalar mp50");
  EXPECT_EQ(reference.exit_code, 0) << reference.text;
  expect_text(reference, " hold, 0 broken");
}

struct Failure {
  const char* mode;
  const char* says;

  friend std::ostream& operator<<(std::ostream& out, const Failure& failure) { return out << failure.mode; }
};

class FailingProgram : public Foreign, public testing::WithParamInterface<Failure> {};

TEST_P(FailingProgram, IsToldApart) {
  // Only one that hangs is waited for to the end.
  const std::string seconds = GetParam().mode == std::string("hang") ? "0.1" : "60";
  const Process failed =
      command(GetParam().mode, "--cases 5 --timeout " + seconds + " --law 'Eq6Laws.Law3*'");
  EXPECT_EQ(failed.exit_code, 4) << failed.text;
  expect_text(failed, GetParam().says);
}

INSTANTIATE_TEST_SUITE_P(Modes, FailingProgram,
                         testing::Values(Failure{"crash", "crashed: signal 11"},
                                         Failure{"exit", "ended with exit code 3"},
                                         Failure{"hang", "hung: no reply within 100 ms"},
                                         Failure{"garbage", "garbage: not JSON: Traceback"},
                                         Failure{"wrong_seq", "was asked, "},
                                         Failure{"truncated", "in the middle of a line: {\"seq\": "},
                                         Failure{"nan", "\"nan\", which is no hexadecimal float"},
                                         Failure{"short_vector", "which is no vector of 2"},
                                         Failure{"no_hello", "the answer to hello has no name"}),
                         [](const auto& test) { return std::string(test.param.mode); });

TEST_F(Foreign, AProgramThatIsNotThereIsTheOtherPrograms) {
  const Process absent = properties("-- ./nothing-here");
  EXPECT_EQ(absent.exit_code, 4);
  expect_text(absent, "./nothing-here: ended with exit code 127");
  EXPECT_EQ(properties("--law Eq9 -- true").exit_code, 2);
  EXPECT_EQ(properties("--library x.so -- true").exit_code, 2);
  EXPECT_EQ(properties("--replay nothing.jsonl").exit_code, 3);
}

TEST_F(Foreign, OnlyWhatIsAmongItsOpsIsAsked) {
  const Process right = command("only_load_offered");
  EXPECT_EQ(right.exit_code, 0) << right.text;
  expect_text(right, "(6) law 1              holds");
  expect_text(right, "(2) law 1              not offered        0 held");
  expect_text(right, "(3) law 1              not offered");
  EXPECT_EQ(right.text.find("REFUSED"), std::string::npos) << right.text;
}

TEST_F(Foreign, ASpinInThePlaneIsShownAsOneNumber) {
  const Process wrong = properties("--cases 40 --law 'RoughLaws.*' -- " + kPython + "no_rebound");
  EXPECT_EQ(wrong.exit_code, 1) << wrong.text;
  EXPECT_TRUE(std::regex_search(wrong.text, std::regex(", 2-D, [^\n]*spin_A = [^(]"))) << wrong.text;
  EXPECT_FALSE(std::regex_search(wrong.text, std::regex(", 2-D, [^\n]*spin_[AB] = \\("))) << wrong.text;
}

TEST_F(Foreign, ALawIsGoneOnWithAtTheCaseThatBrokeIt) {
  const Process alone = command("sign", "--cases 40 --law 'Eq3Laws.Law1*'");
  expect_text(alone, "broken 1; go on, once what is broken is mended, with --seed 20260101 --first ");
  EXPECT_EQ(alone.text.find("--first 40"), std::string::npos) << alone.text;
  const Process among_others = command("sign", "--cases 40 --law 'Eq3Laws.Law1*' --law 'Eq6Laws.*'");
  expect_text(among_others,
              "go on with --seed 20260101 --first 40, or, once what is broken is mended, with ");
}

TEST_F(Foreign, ALibraryThatIsNotThereCannotBeLoaded) {
  const Process none = properties("--library /nonexistent.so");
  EXPECT_EQ(none.exit_code, 4);
  expect_text(none, "nonexistent.so: hello is answered with an error: cannot be loaded: /nonexistent.so: ");
}

TEST_F(Foreign, ARightLibraryPasses) {
  const Process right = properties("--cases 250 --library " TPS_EXAMPLE);
  EXPECT_EQ(right.exit_code, 0) << right.text;
  expect_text(right, "(5) law 6              holds");
  expect_text(right, "order law 1            not offered");
  expect_text(right, "rough law 7            holds");
}

TEST_F(Foreign, ALibraryOfVersion1HasNoEffects) {
  const Process old = properties(
      "--cases 20 --law 'Eq4Laws.*' --law 'WallLaws.*' --law 'RoughLaws.*' --library " TPS_OLD_EXAMPLE);
  EXPECT_EQ(old.exit_code, 0) << old.text;
  expect_text(old, "(4) law 1              holds");
  expect_text(old, "wall law 1             not offered");
  expect_text(old, "rough law 1            not offered");
}

TEST_F(Foreign, ABrokenLibraryIsFound) {
  const Process wrong = properties("--cases 250 --library " TPS_BROKEN_EXAMPLE);
  EXPECT_EQ(wrong.exit_code, 1) << wrong.text;
  expect_text(wrong, "BROKEN (4) law 1");
  expect_text(wrong, "BROKEN tether response law 1");
  EXPECT_EQ(run_shell(TPS_PROGRAM " vectors verify " + file("broken-laws.jsonl")).exit_code, 0);
}

TEST_F(Foreign, AFileThatIsNoLibrarySaysSo) {
  const Process wrong = properties("--library " TPS_SOURCE_DIR "/README.md");
  EXPECT_EQ(wrong.exit_code, 4);
  expect_text(wrong, "cannot be loaded");
}

}  // namespace
}  // namespace tps::properties
