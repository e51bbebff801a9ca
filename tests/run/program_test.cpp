// `tps run` as a process: signals, files that cannot be written or read, exit codes.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>

#include "reference/scene/write_scene.hpp"
#include "tests/run/traced_run.hpp"
#include "verify/scenes/gas.hpp"
#include "verify/scenes/three_body.hpp"
#include "verify/scenes/two_anchors.hpp"

namespace tps {
namespace {

using testing::options_for;
using testing::read_bytes;
using testing::scratch;
using testing::write_bytes;

struct Outcome {
  int code;
  std::string out, err;
};

/// Runs a shell command in which $TPS is the program.
Outcome shell(const std::string& command) {
  const std::string out = scratch("stdout");
  const std::string err = scratch("stderr");
  const std::string script = scratch("script");
  write_bytes(script, "TPS='" TPS_PROGRAM "'\n" + command + "\n");
  const int status = std::system(("bash '" + script + "' >'" + out + "' 2>'" + err + "'").c_str());
  return {WEXITSTATUS(status), read_bytes(out), read_bytes(err)};
}

std::string scene_file(const Scene& scene) {
  const std::string path = scratch("scene.json");
  write_bytes(path, write_scene(scene, SceneStyle::pretty));
  return path;
}

/// A run that takes minutes, as a process; ends it however the test ends.
class LongRun {
 public:
  LongRun() {
    const std::string scene =
        scene_file(build_gas({.particles = 200, .density = .5, .restitution = 1, .duration = 1e6}));
    trace = scratch("long.ndjson");
    std::filesystem::remove(trace);
    pid_ = ::fork();
    if (pid_ == 0) {
      const int null = ::open("/dev/null", O_WRONLY);
      ::dup2(null, STDOUT_FILENO);
      ::dup2(null, STDERR_FILENO);
      ::execl(TPS_PROGRAM, "tps", "run", scene.c_str(), "-o", trace.c_str(), "--state-every", "50", nullptr);
      ::_exit(127);
    }
  }
  ~LongRun() {
    if (pid_ > 0) stop(SIGKILL);
  }

  void wait_for_lines(std::size_t lines) const {
    while (count_lines() < lines) {
      ASSERT_EQ(::waitpid(pid_, nullptr, WNOHANG), 0) << "the run ended by itself";
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
  }
  int stop(int signal) {
    int status = 0;
    ::kill(pid_, signal);
    ::waitpid(pid_, &status, 0);
    pid_ = -1;
    return status;
  }
  std::string trace;

 private:
  std::size_t count_lines() const {
    const std::string bytes = read_bytes(trace);
    return static_cast<std::size_t>(std::count(bytes.begin(), bytes.end(), '\n'));
  }
  pid_t pid_ = -1;
};

std::string complete_lines(const std::string& bytes) {
  return bytes.substr(0, bytes.rfind('\n') + 1);
}

TEST(Process, KilledOutrightLeavesATraceThatGoesOn) {
  LongRun run;
  run.wait_for_lines(200);
  EXPECT_TRUE(WIFSIGNALED(run.stop(SIGKILL)));
  const std::string cut = read_bytes(run.trace);
  const std::size_t events = testing::events_of(complete_lines(cut)).size();  // every complete line is JSON
  EXPECT_EQ(cut.find("{\"end\""), std::string::npos);
  RunOptions on = options_for("double", events + 60);
  on.trace = run.trace;
  resume_run(run.trace, on);
  const std::string resumed = read_bytes(run.trace);
  EXPECT_TRUE(resumed.starts_with(complete_lines(cut)));
  const std::vector<testing::TracedEvent> all = testing::events_of(resumed);
  ASSERT_EQ(all.size(), events + 60);
  for (std::size_t n = 0; n < all.size(); ++n) EXPECT_EQ(all[n].k, n + 1);
  EXPECT_NE(resumed.find("{\"end\":\"max_events\""), std::string::npos);
}

TEST(Process, InterruptedEndsInGoodOrder) {
  for (const int signal : {SIGINT, SIGTERM}) {
    LongRun run;
    run.wait_for_lines(20);
    const int status = run.stop(signal);
    ASSERT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 130);
    const std::string trace = read_bytes(run.trace);
    const std::string last = trace.substr(trace.rfind('\n', trace.size() - 2) + 1);
    EXPECT_TRUE(last.starts_with("{\"end\":\"interrupted\",\"events\":")) << last;
  }
}

TEST(Process, AFullDiskIsAnError) {
  const std::string scene = scene_file(build_three_body({}));
  const Outcome o = shell("$TPS run '" + scene + "' -q -o /dev/full");
  EXPECT_EQ(o.code, 7);
  EXPECT_NE(o.err.find("'/dev/full'"), std::string::npos) << o.err;
  EXPECT_NE(o.err.find("No space left"), std::string::npos) << o.err;
  EXPECT_EQ(shell("$TPS run '" + scene + "' -q > /dev/full").code, 7);
  EXPECT_EQ(shell("$TPS run '" + scene + "' -q --checkpoint /dev/full/x").code, 7);
}

TEST(Process, AClosedPipeIsAnError) {
  const std::string scene = scene_file(build_gas({.particles = 50, .density = .5, .duration = 50}));
  const Outcome o = shell("$TPS run '" + scene + "' -q -o - | head -1 >/dev/null; exit ${PIPESTATUS[0]}");
  EXPECT_EQ(o.code, 7);
  EXPECT_NE(o.err.find("standard output"), std::string::npos) << o.err;
  EXPECT_NE(o.err.find("Broken pipe"), std::string::npos) << o.err;
}

TEST(Process, PathsThatCannotBe) {
  const std::string scene = scene_file(build_three_body({}));
  EXPECT_EQ(shell("$TPS run '" + scene + "' -q -o /nowhere/at/all.ndjson").code, 7);
  EXPECT_EQ(shell("$TPS run '" + scene + "' -q -o " + ::testing::TempDir()).code, 7);
  const std::string empty = scratch("empty");
  write_bytes(empty, "");
  for (const std::string& input : {::testing::TempDir(), empty, std::string("/nowhere/scene.json")}) {
    for (const char* verb : {"run ", "explain ", "run --resume "}) {
      const Outcome o = shell("$TPS " + std::string(verb) + "'" + input + "'");
      EXPECT_EQ(o.code, 3) << verb << input << o.err;
      EXPECT_NE(o.err.find(input), std::string::npos) << o.err;
    }
  }
}

TEST(Process, TimesAndCountsThatAreNone) {
  const std::string scene = scene_file(build_three_body({}));
  for (const char* option : {"--until nan", "--until -1", "--until soon", "--max-events -1",
                             "--state-every 0", "--scalar half", "--detector none"}) {
    EXPECT_EQ(shell("$TPS run '" + scene + "' " + option).code, 2) << option;
  }
  EXPECT_EQ(shell("$TPS run '" + scene + "' --until inf").code, 0);
}

TEST(Process, AStallNamesParticlesAndRemedy) {
  const std::string scene = scene_file(build_two_anchors({}));
  const Outcome o = shell("$TPS run '" + scene + "' -q");
  EXPECT_EQ(o.code, 6);
  for (const char* part : {"0 (anchor)", "1 (anchor)", "2 (particle)", "grouping", "dt_restitute"}) {
    EXPECT_NE(o.err.find(part), std::string::npos) << part << o.err;
  }
  EXPECT_EQ(shell("$TPS run '" + scene_file(build_two_anchors({.grouped = .01})) + "' -q").code, 0);
}

TEST(Process, ATraceGoesToStandardOutputAndOnFromAFileToIt) {
  const std::string scene = scene_file(build_three_body({}));
  const Outcome whole = shell("$TPS run '" + scene + "' -q -o -");
  EXPECT_EQ(whole.code, 0);
  EXPECT_EQ(testing::events_of(whole.out).size(), 70U);
  const std::string cut = scratch("cut.ndjson");
  EXPECT_EQ(shell("$TPS run '" + scene + "' -q -o '" + cut + "' --max-events 20").code, 0);
  const Outcome resumed = shell("$TPS run --resume '" + cut + "' -q -o -");
  EXPECT_EQ(resumed.code, 0) << resumed.err;
  EXPECT_EQ(resumed.out, whole.out);
}

}  // namespace
}  // namespace tps
