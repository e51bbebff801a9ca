// tps properties
#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <optional>
#include <random>

#include "properties/cli/ask_run_laws.hpp"
#include "properties/cli/replay_files.hpp"
#include "properties/explore/explore.hpp"
#include "properties/explore/regressions.hpp"
#include "properties/explore/report.hpp"
#include "properties/implementations/program.hpp"
#include "properties/implementations/reference.hpp"
#include "reference/process/interrupt.hpp"
#include "reference/text/output.hpp"
#include "reference/text/printable.hpp"
#include "verify/cli/line_every.hpp"
#include "verify/cli/named_files.hpp"
#include "verify/cli/numbers.hpp"
#include "verify/cli/say.hpp"
#include "verify/cli/verbs.hpp"
#include "verify/cli/when_called.hpp"
#include "verify/cli/write_result.hpp"

namespace tps::cli {
namespace {

using namespace tps::properties;

constexpr std::uint64_t kCases = 500;
constexpr double kTimeOfAReply = 5, kTimeOfARun = 60;  // seconds

constexpr const char* kPropertiesFooter =
    R"(A law is judged by the unit roundoff of the implementation: hello's "bits", the table's, or --bits.
A law that says bitwise holds to rounding where answers differ by no more than the errors that its operation may
make: that is said, and fails with --bitwise only. A question that has an answer must not be refused.
Exit codes: 0 every law held, 1 a law is broken or a question refused, 4 the implementation crashed, hung or broke the
protocol, 5 no law was met by any case, 130 interrupted.
With --runs the laws are those of whole runs (docs/properties_runs.md), and COMMAND takes the options of `tps run`.
Examples: tps properties --minutes 5
          tps properties --law 'Eq4Laws.*' -- tps serve
          tps properties --library ./libmine.so -o broken.jsonl
          tps properties --runs --cases 20 --seed 1 -- ./my_simulator run)";

struct PropertiesArguments {
  bool list = false;
  bool runs = false, hazards = false;  // laws of whole runs; what their scenes meet
  std::string timing = "stable";       // of the reference's runs
  std::vector<std::string> patterns;
  std::optional<std::uint64_t> cases;
  double minutes = 0;
  std::optional<std::uint64_t> seed;
  std::uint64_t first = 0;
  std::string scalar = "double";
  std::string library;
  int bits = 0;
  std::optional<double> timeout;

  std::chrono::milliseconds time_limit(double seconds) const {
    return std::chrono::milliseconds(static_cast<std::int64_t>(timeout.value_or(seconds) * 1000));
  }
  std::string known_answers;
  std::string regressions;
  std::vector<std::string> replayed;
  std::string format = "text";
  bool quiet = false;
  bool bitwise = false;
  std::vector<std::string> words;

  bool is_foreign() const { return !library.empty() || !words.empty(); }
};

std::unique_ptr<Implementation> subject_of(const PropertiesArguments& a) {
  if (!a.library.empty() && !a.words.empty())
    throw CLI::ValidationError("--library and a command are two implementations; give one");
  ProgramOptions options{a.time_limit(kTimeOfAReply), std::nullopt};
  if (a.bits > 0) options.bits = a.bits;
  if (!a.library.empty()) return shared_library(a.library, options);
  if (!a.words.empty()) return command(a.words, options);
  return reference(a.scalar);
}

Plan plan_of(const PropertiesArguments& a) {
  Plan plan{laws_matching(a.patterns)};
  if (plan.laws.empty()) {
    throw CLI::ValidationError(fmt::format("no law matches {}; tps properties --list shows ids and numbers",
                                           fmt::join(a.patterns, " ")));
  }
  if (a.seed) plan.seed = *a.seed;
  if (!a.seed && a.minutes > 0) plan.seed = std::random_device()();
  plan.first = a.first;
  plan.bitwise = a.bitwise;
  plan.count = a.minutes > 0 ? std::uint64_t{1} << 53 : a.cases.value_or(kCases);
  return plan;
}

/// A line every few seconds.
class RoundsOnStderr {
 public:
  explicit RoundsOnStderr(bool quiet) : line_(std::chrono::seconds(5), quiet) {}

  void operator()(const Exploration& exploration) {
    if (!line_.due()) return;
    say("tps: {} laws to case {} of seed {}, {} cases held, {} broken\n", exploration.laws.size(),
        exploration.next, exploration.plan.seed, exploration.held(), exploration.findings().size());
  }

 private:
  LineEvery line_;
};

/// Where known answers go; empty for nowhere.
std::string known_answers_path(const PropertiesArguments& a) {
  return a.known_answers.empty() && a.is_foreign() ? "broken-laws.jsonl" : a.known_answers;
}

/// What is replayed is not written.
void require_distinct_files(const PropertiesArguments& a) {
  NamedFiles files;
  files.reads("--library", a.library);
  for (const std::string& path : a.replayed) files.reads("--replay", path);
  if (!a.words.empty() && a.words[0].find('/') != std::string::npos) files.reads("command", a.words[0]);
  if (a.replayed.empty() && !a.list)
    files.writes("-o", known_answers_path(a)).writes("--regressions", a.regressions);
  files.require_distinct();
}

/// Findings as files: for people with other programs, and for our own tests.
void keep(const PropertiesArguments& a, const Exploration& exploration) {
  const std::vector<const Finding*> findings = exploration.findings();
  if (findings.empty()) return;
  const std::string known = known_answer_file(findings, exploration.plan.seed);
  const std::string path = known_answers_path(a);
  if (!path.empty() && !known.empty()) {
    write_result(path, known);
    say("tps: known answers to the questions of broken laws: {}\n", path);
  }
  if (a.regressions.empty()) return;
  Output regressions(a.regressions, Output::Append::at_end);
  for (const Finding* finding : findings) regressions.write(regression_line(*finding, exploration.subject));
  regressions.close();
  say("tps: cases of broken laws: {}; tps properties --replay {} asks them again\n", a.regressions,
      a.regressions);
}

int exit_code_of(const Exploration& exploration) {
  if (interrupt::requested()) return kInterrupted;
  int code = exploration.held() > 0 ? kDone : kUndecided;
  for (const Finding* finding : exploration.findings()) {
    if (finding->outcome.kind == properties::Outcome::Kind::failed) return kOtherProgram;
    code = kViolation;
  }
  return code;
}

void say_given_up(const Implementation& subject) {
  const std::string why = subject.given_up();
  if (!why.empty()) say("tps: {}: {}; what follows was not asked\n", subject.name(), why);
}

int explore_laws(const PropertiesArguments& a) {
  const Plan plan = plan_of(a);
  const auto subject = subject_of(a);
  const interrupt::GoodOrder good_order;
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::duration<double>(a.minutes * 60);
  const auto stop = [&] {
    return interrupt::requested() || (a.minutes > 0 && std::chrono::steady_clock::now() > deadline);
  };
  if (!a.quiet && a.minutes > 0) say("tps: seed {}, from case {} of each law\n", plan.seed, plan.first);
  const Exploration exploration = explore(*subject, plan, stop, RoundsOnStderr(a.quiet));
  write_result("-", a.format == "json" ? exploration_json(exploration) : exploration_text(exploration));
  keep(a, exploration);
  say_given_up(*subject);
  return exit_code_of(exploration);
}

int replay_cases(const PropertiesArguments& a) {
  const auto subject = subject_of(a);
  const Replayed replay = replay_files(a.replayed, a.bitwise, *subject);
  write_result("-", a.format == "json" ? replay_json(replay) : replay_text(replay));
  say_given_up(*subject);
  for (const Finding& finding : replay.findings)
    if (finding.outcome.kind == properties::Outcome::Kind::failed) return kOtherProgram;
  if (!replay.findings.empty()) return kViolation;
  return replay.held > 0 ? kDone : kUndecided;
}

/// Laws of whole runs instead of single operations.
int run_properties_of_runs(const PropertiesArguments& a) {
  if (a.scalar == "certified")
    throw CLI::ValidationError("certified answers are of single operations; --runs simulates in a scalar");
  if (a.list || a.hazards) {
    write_result("-", (a.list ? table_of_run_laws() : "") + (a.hazards ? table_of_hazards() : ""));
    return kDone;
  }
  RunLawQuestions questions;
  questions.patterns = a.patterns;
  questions.scalar = a.scalar;
  questions.timing = a.timing;
  questions.cases = a.cases.value_or(questions.cases);
  questions.seed = a.seed ? *a.seed : std::random_device()();
  questions.timeout = a.time_limit(kTimeOfARun);
  questions.command = a.words;
  return ask_run_laws(questions);
}

int run_properties(const PropertiesArguments& a) {
  if (a.words.empty() ? command_line_has_dashes() : a.words[0].empty()) {
    throw CLI::ValidationError(
        "nothing stands behind --; name a command there, or leave -- out to ask the reference");
  }
  if (a.runs) return run_properties_of_runs(a);
  if (a.list) {
    const std::vector<const Law*> chosen = plan_of(a).laws;
    write_result("-", a.format == "json" ? list_json(chosen) : list_text(chosen));
    return kDone;
  }
  require_distinct_files(a);
  try {
    return a.replayed.empty() ? explore_laws(a) : replay_cases(a);
  } catch (const ProgramError& error) {
    say("tps: {}\n", printable_lines(error.what()));
    return kOtherProgram;
  }
}

void add_properties_options(CLI::App* verb, int& exit_code) {
  const auto a = std::make_shared<PropertiesArguments>();
  verb->add_flag("--list", a->list, "Lists the laws instead");
  CLI::Option* runs = verb->add_flag("--runs", a->runs, "Laws of whole runs instead of single operations");
  verb->add_flag("--hazards", a->hazards, "Lists what the scenes of such runs meet")->needs(runs);
  verb->add_option("--timing", a->timing, "Of such runs of the reference")
      ->check(CLI::IsMember({"paper", "stable", "certified"}))
      ->capture_default_str()
      ->needs(runs);
  verb->add_option("--law", a->patterns, "Only laws of this id or number; * stands for anything")->take_all();
  verb->add_option("--cases", a->cases, "Cases of each law (default 500; 100 scenes for --runs)")
      ->check(integer_from(1, "a number of cases"));
  verb->add_option("--minutes", a->minutes, "Instead of --cases: so long, with a seed of its own")
      ->check(number_from(0, 1e5, "a time in minutes"));
  verb->add_option("--seed", a->seed, "Which cases (default: always the same)")
      ->check(integer_from(0, "a seed"));
  verb->add_option("--first", a->first, "Number of the first case, to go on where another run ended")
      ->check(integer_from(0, "the number of a case"));
  std::vector<std::string> scalars = reference_names();
  verb->add_option("--scalar", a->scalar, "The reference in this scalar, or its certified answers")
      ->check(CLI::IsMember(scalars))
      ->capture_default_str();
  verb->add_option("--library", a->library, "A shared library (properties/c_abi/tps_implementation.h)");
  verb->add_option("command", a->words, "Behind --: a command that speaks the protocol (docs/protocol.md)")
      ->transform(as_typed);
  verb->add_option("--bits", a->bits, "Significant bits of its numbers: 53 for double, 24 for float")
      ->check(CLI::Range(8, 400));
  verb->add_flag("--bitwise", a->bitwise,
                 "A law that says bitwise is broken where it holds to rounding only");
  verb->add_option("--timeout", a->timeout, "Seconds for a reply, or for a run (default 5; 60 for --runs)")
      ->check(number_from(0.001, 86400, "a time limit in seconds"));
  verb->add_option("-o,--output", a->known_answers,
                   "Where known answers to the questions of broken laws go (default of a command or library: "
                   "broken-laws.jsonl)");
  verb->add_option("--regressions", a->regressions, "Appends the cases of broken laws to this file")
      ->take_last();
  verb->add_option("--replay", a->replayed, "Asks the cases of such files again")->take_all();
  verb->add_option("--format", a->format)->check(CLI::IsMember({"text", "json"}))->capture_default_str();
  verb->add_flag("--quiet", a->quiet, "No progress");
  for (const char* option : {"--minutes", "--first", "--library", "--bits", "--bitwise", "--output",
                             "--regressions", "--replay", "--format", "--quiet"})
    verb->get_option(option)->excludes(runs);
  verb->footer(kPropertiesFooter);
  verb->callback([=, &exit_code] { exit_code = run_properties(*a); });
}

}  // namespace

void add_properties(CLI::App& app, int& exit_code) {
  CLI::App* verb = app.add_subcommand(
      "properties", "Looks for cases in which an implementation breaks a law, and shrinks them.");
  make_when_called(verb, [&exit_code](CLI::App* called) { add_properties_options(called, exit_code); });
}

}  // namespace tps::cli
