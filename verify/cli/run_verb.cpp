// tps run
#include <fmt/format.h>

#include <atomic>
#include <csignal>
#include <memory>

#include "reference/run/run.hpp"
#include "reference/run/trace_file.hpp"
#include "reference/scene/read_scene.hpp"
#include "verify/certified/exact_timing.hpp"
#include "verify/cli/progress.hpp"
#include "verify/cli/summary.hpp"
#include "verify/cli/verbs.hpp"
#include "verify/cli/write_result.hpp"

namespace tps::cli {
namespace {

std::atomic<bool> interrupted{false};

extern "C" void note_interrupt(int) {
  interrupted.store(true);
}

struct RunArguments {
  std::string scene;
  std::string scalar = "double";
  std::string timing = "stable";
  std::string detector = "all-pairs";
  std::string format = "text";
  std::string resume;
  bool quiet = false;
  RunOptions options;
};

/// CLI11's own ranges let "nan" through, with which a run would have no end.
std::string not_before_start(std::string& text) {
  double time = 0;
  if (CLI::detail::lexical_cast(text, time) && time >= 0) return {};
  return "'" + text + "' is not a time; allowed are numbers from 0, and inf";
}

RunSummary simulate(RunArguments& a) {
  if (a.resume.empty()) return run_scene(read_scene_file(a.scene), a.options);
  if (a.options.trace.empty() && !is_checkpoint(a.resume)) a.options.trace = a.resume;
  return resume_run(a.resume, a.options);
}

int run(RunArguments& a) {
  a.options.scalar = *scalar_kind(a.scalar);
  a.options.timing = *timing_named(a.timing);
  if (!can_be_timed(a.options.scalar, a.options.timing)) {
    throw CLI::ValidationError("--timing certified",
                               "answers for the numbers of a run in float or double, not " + a.scalar +
                                   "; give one of these, or --timing stable");
  }
  certified::ExactTiming certifier;
  a.options.certifier = &certifier;
  a.options.interrupt = &interrupted;
  std::signal(SIGINT, note_interrupt);
  std::signal(SIGTERM, note_interrupt);
  RunSummary summary;
  {
    ProgressReport report(a.quiet);
    a.options.progress = [&](const RunOptions::Progress& progress) { report.update(progress); };
    summary = simulate(a);
  }
  const std::string text = a.format == "json" ? summary_json(summary) : summary_text(summary);
  if (a.options.trace == "-") {
    if (!a.quiet) fmt::print(stderr, "{}", text);
  } else {
    write_result("-", text);
  }
  if (summary.end == "stalled") {
    fmt::print(stderr, "tps: the run stalled: {}\n", stall_message(summary));
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
  verb->add_option("--detector", a->detector, "How the next collision is found")
      ->check(CLI::IsMember({"all-pairs"}))
      ->capture_default_str();
  verb->add_option("--until", a->options.until, "End at this time instead of the scene's duration")
      ->check(CLI::Validator(not_before_start, "TIME"));
  verb->add_option("--max-events", a->options.max_events, "End after this many events")
      ->check(CLI::NonNegativeNumber);
  CLI::Option* state_every =
      verb->add_option(
              "--state-every", a->options.state_every,
              "Events between full states in the trace (default: 1000, or 10 a particle if that is more)")
          ->check(CLI::PositiveNumber);
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
