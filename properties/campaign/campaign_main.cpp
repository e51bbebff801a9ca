// The campaign: nasty scenes × scalars × timings, run and checked; every alarm with the commands that show it
// again.
#include <sys/wait.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <array>
#include <iostream>
#include <map>
#include <sstream>

#include "properties/campaign/trial.hpp"
#include "reference/scene/write_scene.hpp"

namespace tps::properties::campaign {
namespace {

struct Options {
  std::uint64_t seed = 20260101, first = 0, count = 3000, max_events = 60;
  unsigned seconds = 120;
  std::string only_scalar, only_timing;
  bool beyond = false, quiet = false;
  std::int64_t show = -1;
};

/// What came of the trials of one mode, as a line of figures between processes.
struct Tally {
  std::uint64_t passed = 0, undecided_runs = 0, undecided = 0, inconclusive = 0, left_range = 0, alarms = 0,
                events = 0;

  void add(const Trial& trial) {
    passed += trial.fate == Fate::passed;
    undecided_runs += trial.fate == Fate::undecided;
    left_range += trial.fate == Fate::left_range;
    alarms += trial.fate == Fate::alarm;
    undecided += trial.undecided;
    inconclusive += trial.inconclusive;
    events += trial.events;
  }
  void add(const Tally& other) {
    passed += other.passed, undecided_runs += other.undecided_runs, undecided += other.undecided,
        inconclusive += other.inconclusive, left_range += other.left_range, alarms += other.alarms,
        events += other.events;
  }
};

std::string commands(const Options& options, std::uint64_t n, const Mode& mode) {
  std::ostringstream out;
  out << "tps_campaign --seed " << options.seed << " --show " << n << " | tps run - -q -o t.ndjson --scalar "
      << mode.scalar << " --timing " << mode.timing << " --max-events " << options.max_events
      << " --state-every " << kStateEvery << "; tps check t.ndjson";
  return out.str();
}

void tell(const Options& options, std::uint64_t n, const NastyScene& nasty, const Mode& mode,
          const std::string& message) {
  std::cout << "ALARM scene " << n << " (" << nasty.kind << ") " << mode.scalar << " " << mode.timing << ": "
            << message << "\n  " << commands(options, n, mode) << std::endl;
}

/// A trial in a process of its own, so that a crash or a hang is an alarm and not the end of the campaign.
Tally tried_apart(const Options& options, std::uint64_t n, const NastyScene& nasty, const Mode& mode) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) throw std::runtime_error("no pipe for a trial");
  std::cout.flush();
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("no process for a trial");
  if (child == 0) {
    alarm(options.seconds);
    const Trial trial = try_scene(nasty, mode, options.max_events);
    Tally tally;
    tally.add(trial);
    if (trial.fate == Fate::alarm) tell(options, n, nasty, mode, trial.message);
    const bool sent = write(ends[1], &tally, sizeof tally) == static_cast<ssize_t>(sizeof tally);
    std::cout.flush();
    _exit(sent ? 0 : 1);
  }
  close(ends[1]);
  Tally tally;
  const bool complete = read(ends[0], &tally, sizeof tally) == static_cast<ssize_t>(sizeof tally);
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  if (complete) return tally;
  const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  const std::string what = signal == SIGALRM ? "no end within " + std::to_string(options.seconds) + " s"
                                             : "the process dies of signal " + std::to_string(signal);
  tell(options, n, nasty, mode, what);
  tally = {};
  tally.alarms = 1;
  return tally;
}

bool is_wanted(const Options& options, const Mode& mode, std::uint64_t n) {
  return n % static_cast<std::uint64_t>(mode.once_in) == 0 &&
         (options.only_scalar.empty() || options.only_scalar == mode.scalar) &&
         (options.only_timing.empty() || options.only_timing == mode.timing);
}

void print(const std::map<std::string, Tally>& tallies) {
  std::cout
      << "mode                     runs   events  passed undecided(steps) inconclusive left-range alarms\n";
  Tally all;
  for (const auto& [mode, t] : tallies) {
    const std::uint64_t runs = t.passed + t.undecided_runs + t.left_range + t.alarms;
    std::printf("%-22s %6lu %8lu %7lu %9lu(%5lu) %12lu %10lu %6lu\n", mode.c_str(), runs, t.events, t.passed,
                t.undecided_runs, t.undecided, t.inconclusive, t.left_range, t.alarms);
    all.add(t);
  }
  std::printf("alarms: %lu\n", all.alarms);
}

int run(const Options& options) {
  if (options.show >= 0) {
    std::cout << write_scene(nasty_scene(options.seed, static_cast<std::uint64_t>(options.show)).scene);
    return 0;
  }
  std::map<std::string, Tally> tallies;
  std::uint64_t alarms = 0;
  for (std::uint64_t n = options.first; n < options.first + options.count; ++n) {
    const NastyScene nasty = nasty_scene(options.seed, n);
    for (const Mode& mode : all_modes()) {
      if (!is_wanted(options, mode, n)) continue;
      if (!options.beyond && !is_resolved(nasty.scene, mode.scalar, mode.timing)) continue;
      const Tally tally = tried_apart(options, n, nasty, mode);
      tallies[mode.scalar + " " + mode.timing].add(tally);
      alarms += tally.alarms;
    }
  }
  print(tallies);
  return alarms == 0 ? 0 : 1;
}

}  // namespace
}  // namespace tps::properties::campaign

int main(int argc, char** argv) {
  using namespace tps::properties::campaign;
  Options options;
  CLI::App app{
      "Runs and checks random scenes that arithmetic is bad at, in every scalar and timing. Exit code 1 if "
      "there is an alarm.\n"
      "Example: tps_campaign --seed 1 --count 3000"};
  app.add_option("--seed", options.seed);
  app.add_option("--first", options.first, "number of the first scene");
  app.add_option("--count", options.count, "scenes");
  app.add_option("--max-events", options.max_events, "of each run");
  app.add_option("--scalar", options.only_scalar, "this one only");
  app.add_option("--timing", options.only_timing, "this one only");
  app.add_option("--seconds", options.seconds, "a run that takes longer is an alarm");
  app.add_flag("--beyond", options.beyond, "scalars that cannot tell the scene's places apart, too");
  app.add_option("--show", options.show, "prints the scene of this number instead");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  try {
    return run(options);
  } catch (const std::exception& error) {
    std::cerr << "tps_campaign: " << error.what() << "\n";
    return 4;
  }
}
