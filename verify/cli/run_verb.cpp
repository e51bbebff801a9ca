// tps run
#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "reference/process/interrupt.hpp"
#include "reference/run/end_of_times.hpp"
#include "reference/run/resume.hpp"
#include "reference/run/run.hpp"
#include "reference/run/trace_file.hpp"
#include "reference/scene/read_scene.hpp"
#include "reference/text/number_text.hpp"
#include "reference/text/printable.hpp"
#include "verify/certified/exact_timing.hpp"
#include "verify/cli/named_files.hpp"
#include "verify/cli/numbers.hpp"
#include "verify/cli/progress.hpp"
#include "verify/cli/say.hpp"
#include "verify/cli/start_notice.hpp"
#include "verify/cli/summary.hpp"
#include "verify/cli/verbs.hpp"
#include "verify/cli/write_result.hpp"

namespace tps::cli {
namespace {

struct RunArguments {
  std::string scene;
  std::string scalar = "double";
  std::string timing = "stable";
  std::string detector = "automatic";
  std::string format = "text";
  std::string resume;
  bool quiet = false;
  RunOptions options;
};

/// A trace may go on where it ends, and a checkpoint be replaced by a later one of the same run; nothing else
/// that is read is written, too.
void require_distinct_files(const RunArguments& a) {
  NamedFiles files;
  files.reads("scene", a.scene).writes("-o", a.options.trace).writes("--checkpoint", a.options.checkpoint);
  if (!a.options.checkpoint.empty())
    files.writes("what becomes --checkpoint,", a.options.checkpoint + ".unfinished");
  if (!a.resume.empty()) {
    const bool from_checkpoint = is_checkpoint(a.resume);
    const std::string& goes_on = from_checkpoint ? a.options.checkpoint : a.options.trace;
    if (!are_one_file(a.resume, goes_on)) files.reads("--resume", a.resume);
  }
  files.require_distinct();
}

RunSummary resumed(const RunArguments& a, bool& unprotected) try {
  return resume_run(a.resume, a.options, unprotected);
} catch (const EndsBeforeState& problem) {
  throw CLI::ValidationError(
      "--until",
      fmt::format("{} is before {}, where the last full state of {} stands (both count from the start){}; "
                  "give a time from there on, or run its scene from the start",
                  write_shortest(problem.until), problem.now, printable(a.resume),
                  a.options.until ? "" : ", and is the scene's duration"));
}

/// A signal while the scene is read ends the program; from then on it ends the run, and its trace, in good
/// order.
RunSummary simulate(RunArguments& a, StartNotice& notice) {
  if (a.resume.empty()) {
    require_distinct_files(a);
    notice.doing(fmt::format("reading {}", a.scene));
    const Scene scene = read_scene_file(a.scene);
    const std::size_t n = scene.particles.size();
    notice.doing(fmt::format("times of the {} pairs of {} particles", n < 2 ? 0 : n * (n - 1) / 2, n));
    const interrupt::GoodOrder good_order;
    return run_scene(scene, a.options);
  }
  if (a.options.trace.empty() && !is_checkpoint(a.resume)) a.options.trace = a.resume;
  require_distinct_files(a);
  notice.doing(fmt::format("taking up the last full state of {}", a.resume));
  const interrupt::GoodOrder good_order;
  bool unprotected = false;
  RunSummary summary = resumed(a, unprotected);
  if (unprotected) {
    say("tps: note: the full state of {} has no checksum, as those of older versions: nothing would have "
        "shown damage to it\n",
        printable(a.resume));
  }
  return summary;
}

int run(RunArguments& a) {
  a.options.scalar = *scalar_kind(a.scalar);
  a.options.timing = *timing_named(a.timing);
  a.options.detector = *detector_named(a.detector);
  if (!can_be_timed(a.options.scalar, a.options.timing)) {
    throw CLI::ValidationError("--timing certified",
                               "answers for the numbers of a run in float or double, not " + a.scalar +
                                   "; give one of these, or --timing stable");
  }
  certified::ExactTiming certifier;
  a.options.certifier = &certifier;
  a.options.interrupt = &interrupt::flag();
  RunSummary summary;
  {
    ProgressReport report(a.quiet, "t");
    StartNotice notice(a.quiet);
    a.options.progress = [&](const RunOptions::Progress& progress) {
      notice.stop();
      report.update({progress.t, progress.duration, progress.events});
    };
    summary = simulate(a, notice);
  }
  const std::string text = a.format == "json" ? summary_json(summary) : summary_text(summary);
  if (a.options.trace == "-") {
    if (!a.quiet) say("{}", text);
  } else {
    write_result("-", text);
  }
  if (summary.end == "stalled") {
    say("tps: the run stalled: {}\n", stall_message(summary));
    return kStalled;
  }
  if (summary.end == "out_of_range") {
    fmt::print(stderr, "tps: the run left the range of its scalar: {}\n", range_message(summary));
    return kOutOfRange;
  }
  if (!conserves(summary)) {
    fmt::print(stderr,
               "tps: energy or momentum is beyond its bound, which no run should be; please report it\n");
    return kViolation;
  }
  return summary.end == "interrupted" ? kInterrupted : kDone;
}

}  // namespace

void add_run(CLI::App& app, int& exit_code) {
  const auto a = std::make_shared<RunArguments>();
  CLI::App* verb =
      app.add_subcommand("run", "Simulates a scene; prints a summary, writes a trace if asked to.");
  CLI::Option* scene = verb->add_option("scene", a->scene, "Scene file, - for standard input");
  verb->add_option("-o,--output", a->options.trace,
                   "Write the trace here, - for standard output (the summary then goes to standard error)");
  CLI::Option* scalar = verb->add_option("--scalar", a->scalar, "Type of every number in the run")
                            ->check(CLI::IsMember(scalar_names()))
                            ->capture_default_str();
  CLI::Option* timing =
      verb->add_option("--timing", a->timing,
                       "How eq. (2) is answered: as printed, without cancellation, or as real arithmetic "
                       "answers on the stored numbers, order included")
          ->check(CLI::IsMember(timing_names()))
          ->capture_default_str();
  verb->add_option(
          "--detector", a->detector,
          "How the next collision is found: by asking every pair, or neighbours only. The run is the same")
      ->check(CLI::IsMember(detector_names()))
      ->capture_default_str();
  verb->add_option("--until", a->options.until, "End at this time instead of the scene's duration")
      ->check(number_from(0, HUGE_VAL, "a time"));
  verb->add_option("--max-events", a->options.max_events, "End after this many events")
      ->check(integer_from(0, "a number of events"));
  CLI::Option* state_every =
      verb->add_option(
              "--state-every", a->options.state_every,
              "Events between full states in the trace (default: 1000, or 10 a particle if that is more)")
          ->check(integer_from(1, "a number of events"));
  verb->add_option("--checkpoint", a->options.checkpoint, "Keep the latest full state in this file");
  CLI::Option* resume =
      verb->add_option("--resume", a->resume,
                       "Go on from the last full state of a trace (by default in that "
                       "file) or checkpoint; scene, scalar, timing and state-every are the file's");
  verb->add_option("--format", a->format, "Of the summary")
      ->check(CLI::IsMember({"text", "json"}))
      ->capture_default_str();
  verb->add_flag("-q,--quiet", a->quiet, "No progress on standard error");
  resume->excludes(scene)->excludes(scalar)->excludes(timing)->excludes(state_every);
  verb->footer(
      "Example: tps run data/scenes/terminal.json -o terminal.ndjson\n"
      "         tps run --resume terminal.ndjson");
  verb->callback([=, &exit_code] {
    if (scene->count() + resume->count() != 1) throw CLI::RequiredError("a scene file, or --resume FILE,");
    exit_code = run(*a);
  });
}

}  // namespace tps::cli
