// The command: what people, programs and CI systems read, and what it makes of files that are no traces.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "tests/trace_check/check_command.hpp"

namespace tps {
namespace {

using nlohmann::json;

TEST_F(Check, AGoodTraceConforms) {
  const Outcome outcome = check(file("good"));
  EXPECT_EQ(outcome.exit_code, 0);
  expect_text(outcome, "70 events");
  expect_text(outcome, "conforming");
}

TEST_F(Check, AViolationIsNamedWithPlaceEquationAndPage) {
  write_wrong_impulse();
  const Outcome outcome = check(file("bad"));
  EXPECT_EQ(outcome.exit_code, 1);
  expect_text(outcome, "line 4, event 2");
  expect_text(outcome, "Δp of 1-2 is");
  expect_text(outcome, "eq. (4); see docs/check.md, impulse");
  expect_text(outcome, "ulp, allowed");
}

TEST_F(Check, JsonHasTheSame) {
  write_wrong_impulse();
  const json report = json::parse(check(file("bad") + " --format json").text);
  EXPECT_FALSE(report["conforming"]);
  EXPECT_EQ(report["events"], 70);
  EXPECT_EQ(report["rules"].size(), 15U);
  const json& first = report["findings"][0];
  EXPECT_EQ(first["rule"], "impulse");
  EXPECT_EQ(first["line"], 4);
  EXPECT_EQ(first["page"], "docs/check.md#impulse");
  EXPECT_EQ(first["replay"]["op"], "collision_impulse");
  EXPECT_GT(first["off_ulps"].get<double>(), first["allowed_ulps"].get<double>());
}

TEST_F(Check, JUnitIsXmlWithACaseForEachRule) {
  write_wrong_impulse();
  EXPECT_EQ(check(file("bad") + " --format junit -o " + file("report.xml")).exit_code, 1);
  const Outcome parsed = run_shell(
      "python3 -c 'import sys,xml.etree.ElementTree as e; s=e.parse(sys.argv[1]).getroot(); "
      "print(len(s), s.get(\"failures\"), [c.get(\"name\") for c in s if c.find(\"failure\") is not "
      "None])' " +
      file("report.xml"));
  EXPECT_EQ(parsed.text, "15 1 ['impulse']\n");
}

// Reports are capped for each rule, counts are not; the check goes on behind the first violation.
TEST_F(Check, ReportsAreCapped) {
  std::string text = content(file("good"));
  const std::string negative = "\"dp\":[\"-0x";
  for (std::size_t at = text.find(negative); at != std::string::npos; at = text.find(negative, at)) {
    text.erase(at + negative.find('-'), 1);
  }
  write("bad", text);
  const json report = json::parse(check(file("bad") + " --format json --max-reports 2").text);
  int impulse_findings = 0;
  for (const json& finding : report["findings"]) impulse_findings += finding["rule"] == "impulse" ? 1 : 0;
  EXPECT_EQ(impulse_findings, 2);
  EXPECT_GT(report["violated"].get<int>(), 10);
}

TEST_F(Check, ToleranceScalesTheBounds) {
  std::string text = broken("{\"k\":2,", "\"dt\":\"0x1.", "\"dt\":\"0x1.");
  const std::size_t digit = text.find("\"dt\":\"0x1.", text.find("{\"k\":2,")) + 10 + 9;
  text[digit] = text[digit] == '0' ? '1' : '0';
  write("bad", text);
  EXPECT_EQ(check(file("bad")).exit_code, 1);
  EXPECT_EQ(check(file("bad") + " --tolerance 1e8").exit_code, 0);
  EXPECT_EQ(check(file("bad") + " --tolerance 0").exit_code, 2);
  EXPECT_EQ(check(file("bad") + " --tolerance nan").exit_code, 2);
}

// The first witness of a violation is a known answer that proves itself and that others can replay.
TEST_F(Check, TheWitnessIsAKnownAnswer) {
  write_wrong_impulse();
  EXPECT_EQ(check(file("bad") + " --witness " + file("witness.jsonl")).exit_code, 1);
  EXPECT_EQ(run_shell(kTps + " vectors verify " + file("witness.jsonl")).exit_code, 0);
  EXPECT_EQ(run_shell("python3 " TPS_SOURCE_DIR "/data/verify_vectors.py " + file("witness.jsonl")).exit_code,
            0);
  std::ifstream lines(file("witness.jsonl"));
  std::string header, known;
  std::getline(lines, header);
  std::getline(lines, known);
  const json one = json::parse(known);
  EXPECT_NE(one["why"].get<std::string>().find("1-2"), std::string::npos);
  write("in.json", one["in"].dump());
  const Outcome eval = run_shell(kTps + " eval " + json::parse(header)["op"].get<std::string>() +
                                 " --in - < " + file("in.json"));
  EXPECT_EQ(eval.exit_code, 0) << eval.text;
  expect_text(eval, "Δp");
}

TEST_F(Check, NoWitnessIsSaid) {
  const Outcome outcome = check(file("good") + " --witness " + file("none"));
  EXPECT_EQ(outcome.exit_code, 0);
  expect_text(outcome, "no witness");
}

TEST_F(Check, TheSceneMayBeGivenAgain) {
  EXPECT_EQ(check(file("good") + " --scene " TPS_SOURCE_DIR "/data/scenes/three-body.json").exit_code, 0);
  const Outcome other = check(file("good") + " --scene " TPS_SOURCE_DIR "/data/scenes/pair.json");
  EXPECT_EQ(other.exit_code, 1);
  expect_text(other, "the scene of the trace is not that of");
}

TEST_F(Check, StandardInputIsATraceToo) {
  EXPECT_EQ(run_shell(kTps + " check - < " + file("good")).exit_code, 0);
}

TEST_F(Check, WhatIsNoTraceIsRefusedWithAReason) {
  const auto refused = [&](const std::string& name, const std::string& text, const std::string& reason) {
    write(name, text);
    const Outcome outcome = check(file(name));
    EXPECT_EQ(outcome.exit_code, 3) << name;
    expect_text(outcome, reason);
  };
  refused("empty", "", "is empty; a trace starts with");
  refused("garbage", std::string("\x00\xff\xfe{]", 5), ":1:");
  refused("scene", content(TPS_SOURCE_DIR "/data/scenes/pair.json"), "");
  refused("number", "7\n", "is not the first line of a trace");
  refused("checkpoint", "{\"checkpoint\":1}\n", "is a checkpoint");
  refused("bare", "{\"trace\":1,\"options\":{\"state_every\":1}}\n", "has no \"scene\"");
  refused("scalar", "{\"trace\":1,\"scalar\":\"half\"}\n", "/scalar \"half\" is none of float, double");
  refused("form", "{\"trace\":1,\"form\":\"tiny\"}\n", "/form \"tiny\"");
  refused("key", "{\"trace\":1,\"sclar\":\"double\"}\n", "/sclar is not known in a header");
  EXPECT_EQ(check(file("nowhere")).exit_code, 3);
  const Outcome directory = check(std::filesystem::temp_directory_path().string());
  EXPECT_EQ(directory.exit_code, 3);
  expect_text(directory, "is a directory");
}

// Truncated anywhere: no crash, no pass; what was there is judged.
TEST_F(Check, ATruncatedTraceIsNotConforming) {
  const std::string good = content(file("good"));
  for (std::size_t length = good.find('\n') + 1; length + 1 < good.size(); length += 997) {
    write("cut", good.substr(0, length));
    const Outcome outcome = check(file("cut"));
    EXPECT_EQ(outcome.exit_code, 1) << length;
    expect_text(outcome, "the trace has no end");
  }
}

TEST_F(Check, BrokenLinesAreReportedAndPassedOver) {
  const std::string good = content(file("good"));
  const std::size_t second = good.find("{\"k\":2,");
  const auto with = [&](const std::string& line) {
    return good.substr(0, second) + line + "\n" + good.substr(second);
  };
  for (const auto& [line, reason] : {std::pair<std::string, std::string>("nonsense", "is not JSON"),
                                     {"[1,2]", "is not an object"},
                                     {std::string("{\"k\":\"\xc3\x28\"}"), "is not JSON"},
                                     {"{\"k\":2}", "has no \"t\""},
                                     {"{\"kk\":2}", "did you mean k?"},
                                     {"", "is not JSON"}}) {
    write("bad", with(line));
    const Outcome outcome = check(file("bad"));
    EXPECT_EQ(outcome.exit_code, 1);
    expect_text(outcome, reason);
    expect_text(outcome, "schema        VIOLATED");
    expect_text(outcome, "70 events");
  }
}

/// What bounds a program's memory by a gigabyte. The address sanitizer reserves terabytes of addresses.
#ifdef __SANITIZE_ADDRESS__
const std::string kBounded =
    "export ASAN_OPTIONS=$ASAN_OPTIONS:quarantine_size_mb=16:hard_rss_limit_mb=1000; ";
#else
const std::string kBounded = "ulimit -v 1000000; ";
#endif

// A line of any length costs a bounded amount of memory, and the check goes on behind it.
TEST_F(Check, AnEndlessLineIsPassedOver) {
  const Outcome outcome = run_shell("(head -n 2 " + file("good") +
                                    "; head -c 300000000 /dev/zero | tr '\\0' 'x'; echo; tail -n +3 " +
                                    file("good") + ") | (" + kBounded + kTps + " check -q -)");
  EXPECT_EQ(outcome.exit_code, 1) << outcome.text;
  expect_text(outcome, "is longer than any line of this trace can be");
  expect_text(outcome, "70 events");
}

TEST_F(Check, AReaderThatLeavesIsAnErrorOfWriting) {
  const Outcome gone = run_shell("(" + kTps + " check " + file("good") + "; echo \"exit $?\" >&2) | true");
  EXPECT_TRUE(gone.text.find("exit 7") != std::string::npos || gone.text.find("exit 0") != std::string::npos)
      << gone.text;
  const Outcome full = check(file("good") + " -o /dev/full");
  EXPECT_EQ(full.exit_code, 7);
}

TEST_F(Check, AnInterruptReportsWhatWasJudged) {
  const Outcome interrupted =
      run_shell("d=$(mktemp -d); mkfifo $d/in; " + kTps +
                " check -q - < $d/in > $d/out & p=$!; exec 3> $d/in; head -n 5 " + file("good") +
                " >&3; sleep 0.3; kill -INT $p; wait $p; echo \"exit $?\"; cat $d/out; rm -r $d");
  expect_text(interrupted, "exit 130");
  expect_text(interrupted, "interrupted after line");
}

}  // namespace
}  // namespace tps
