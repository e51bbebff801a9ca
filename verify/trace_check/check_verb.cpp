// tps check

#include <cmath>
#include <filesystem>
#include <memory>

#include "reference/process/interrupt.hpp"
#include "reference/text/output.hpp"
#include "verify/cli/named_files.hpp"
#include "verify/cli/numbers.hpp"
#include "verify/cli/progress.hpp"
#include "verify/cli/say.hpp"
#include "verify/cli/verbs.hpp"
#include "verify/cli/write_result.hpp"
#include "verify/trace_check/check.hpp"
#include "verify/trace_check/witness.hpp"
#include "verify/view/checked_page.hpp"
#include "verify/view/page.hpp"

namespace tps::cli {
namespace {

struct CheckArguments {
  std::string trace;
  std::string format = "text";
  std::string output = "-";
  std::string witness;
  std::string view;
  bool quiet = false;
  check::CheckOptions options;
};

void write_witness(const std::string& path, const check::CheckReport& report) {
  const std::string cases = check::witness_cases(report);
  if (cases.empty()) {
    say("tps: no witness: no violation is a step of one operation\n");
    return;
  }
  Output out(path);
  out.write(cases);
  out.close();
}

/// With progress by the size of the file, where it has one.
check::CheckReport judged(CheckArguments& a) {
  constexpr double kMega = 1e6;
  std::error_code no_size;
  const auto size = std::filesystem::file_size(a.trace, no_size);
  const double whole = no_size ? HUGE_VAL : static_cast<double>(size) / kMega;
  ProgressReport progress(a.quiet, "MB");
  a.options.progress = [&](const check::CheckOptions::Progress& p) {
    progress.update({static_cast<double>(p.bytes) / kMega, whole, p.events});
  };
  const interrupt::GoodOrder good_order;
  return check::check_trace(a.trace, a.options);
}

/// Before anything is judged: whether the page can be made.
void require_page(const CheckArguments& a) {
  view::require_viewer();
  if (a.trace == "-") {
    throw CLI::ValidationError(
        "--view", "the page reads the trace a second time, which standard input does not allow; name a file");
  }
}

int run_check(CheckArguments& a) {
  NamedFiles()
      .reads("trace", a.trace)
      .reads("--scene", a.options.scene)
      .writes("-o", a.output)
      .writes("--witness", a.witness)
      .writes("--view", a.view)
      .require_distinct();
  // Of no report: a program that cannot write them says so before it judges.
  if (!a.witness.empty()) static_cast<void>(check::witness_cases({}));
  if (!a.view.empty()) require_page(a);
  a.options.interrupt = &interrupt::flag();
  const check::CheckReport report = judged(a);
  const std::string text = a.format == "json"    ? check::report_json(report)
                           : a.format == "junit" ? check::report_junit(report)
                                                 : check::report_text(report);
  write_result(a.output, text);
  if (!a.witness.empty()) write_witness(a.witness, report);
  if (report.interrupted) return kInterrupted;
  if (!a.view.empty()) write_result(a.view, view::checked_page(a.trace, a.options.scene, report));
  if (!report.conforming()) return kViolation;
  return report.inconclusive() ? kUndecided : kDone;
}

}  // namespace

void add_check(CLI::App& app, int& exit_code) {
  const auto a = std::make_shared<CheckArguments>();
  CLI::App* verb =
      app.add_subcommand("check", "Judges a trace step by step: is it right, and if not, where first?");
  verb->add_option("trace", a->trace, "Trace file, - for standard input")->required();
  verb->add_option("--scene", a->options.scene,
                   "The scene that the trace has to be of (a minimal trace may lack its own)");
  verb->add_option("--tolerance", a->options.tolerance, "Multiplies every derived bound")
      ->check(number_above_zero(1e9, "a factor"))
      ->capture_default_str();
  verb->add_flag("--trust-draws", a->options.trust_draws,
                 "Take recorded draws as given instead of asking the generator of the scene's seed for them");
  verb->add_option("--max-reports", a->options.max_reports, "Findings shown in full, for each rule")
      ->check(integer_from(0, "a number of findings"))
      ->capture_default_str();
  verb->add_option("--jobs", a->options.jobs,
                   "Threads that judge a trace in segments from its full states; 0: one a processor. The "
                   "report is the same")
      ->check(CLI::Range(0U, 1024U))
      ->capture_default_str();
  verb->add_option("--format", a->format)
      ->check(CLI::IsMember({"text", "json", "junit"}))
      ->capture_default_str();
  verb->add_option("-o,--output", a->output, "Write the report here, - for standard output")
      ->capture_default_str();
  verb->add_option(
      "--witness", a->witness,
      "Write the first violation of each rule here, as known-answer cases for tps vectors and tps eval");
  verb->add_option(
      "--view", a->view,
      "Write a page here that plays the trace, marks what was found and opens at the first finding");
  verb->add_flag("-q,--quiet", a->quiet, "No progress on standard error");
  verb->footer(
      "Exit code 1 if a rule is violated, 5 if more than one step in a hundred is undecided.\n"
      "The rules, their bounds and the minimal form of a trace: docs/check.md.\n"
      "Example: tps run data/scenes/pair.json -o pair.ndjson && tps check pair.ndjson");
  verb->callback([=, &exit_code] { exit_code = run_check(*a); });
}

}  // namespace tps::cli
