// tps conform
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <memory>
#include <stdexcept>

#include "properties/conform/ask_all.hpp"
#include "properties/conform/hypotheses.hpp"
#include "properties/conform/inquiry.hpp"
#include "properties/conform/offered_names.hpp"
#include "properties/conform/profile.hpp"
#include "properties/conform/random_scene.hpp"
#include "properties/conform/random_scene_verb.hpp"
#include "properties/conform/report.hpp"
#include "properties/implementations/program.hpp"
#include "properties/implementations/reference.hpp"
#include "reference/process/interrupt.hpp"
#include "reference/text/input_error.hpp"
#include "reference/text/printable.hpp"
#include "verify/cli/line_every.hpp"
#include "verify/cli/named_files.hpp"
#include "verify/cli/numbers.hpp"
#include "verify/cli/say.hpp"
#include "verify/cli/verbs.hpp"
#include "verify/cli/when_called.hpp"
#include "verify/cli/write_result.hpp"
#include "verify/vectors/generate.hpp"

namespace tps::cli {
namespace {

using namespace tps::properties;
using namespace tps::properties::conform;

constexpr const char* kConformFooter =
    R"(One verdict on an implementation in any language: known answers, laws and whole runs. A COMMAND speaks the protocol
(docs/protocol.md). Every answer has a class; by default WRONG and REFUSED fail (--profile moves the line).
Exit codes: 0 conforming, 1 not conforming, 4 the program crashed, hung or broke the protocol, 5 nothing was asked,
130 interrupted.
Examples: tps conform -- python3 mine.py
          tps conform --profile double-stable --library ./libmine.so
          tps conform --simulator './my_simulator' --features no-groups,no-draws
          tps conform --ops block_time,tether_time --level 1 -- ./mine)";

struct ConformArguments {
  std::vector<std::string> words, ops, strata, features;
  std::string library, scalar, simulator, profile = "default", expected;
  std::string format = "text", report = "-";
  int level = 2, bits = 0;
  std::uint64_t law_cases = 0, seed = 20260101, scenes = 0, first_scene = 0;
  double timeout = 0, shrink_seconds = 2, total = 0;
  bool quiet = false, all = false, hypotheses = false;
};

/// A hundred events and the start of an interpreter take longer than an answer.
constexpr double kSecondsForAReply = 5, kSecondsForARun = 10;

std::chrono::milliseconds time_limit(const ConformArguments& a, double by_default) {
  return std::chrono::milliseconds(static_cast<int>((a.timeout > 0 ? a.timeout : by_default) * 1000));
}

bool is_simulator_alone(const ConformArguments& a) {
  return !a.simulator.empty() && a.words.empty() && a.library.empty() && a.scalar.empty();
}

/// Null where whole runs alone are asked.
std::unique_ptr<Implementation> subject_of(const ConformArguments& a, const Profile& profile) {
  if (is_simulator_alone(a)) return nullptr;
  const int given = int(!a.library.empty()) + int(!a.words.empty()) + int(!a.scalar.empty());
  if (given != 1) {
    throw CLI::ValidationError(
        "name one implementation: a command behind --, --library FILE, or the reference by --scalar; or a "
        "simulator by --simulator, or both");
  }
  ProgramOptions options{time_limit(a, kSecondsForAReply), profile.bits};
  if (a.bits > 0) options.bits = a.bits;
  if (!a.library.empty()) return shared_library(a.library, options);
  if (!a.words.empty()) return command(a.words, options);
  return reference(a.scalar);
}

/// Patterns of rows, a line each; # begins a comment.
std::vector<std::string> expected_failures(const std::string& path) {
  std::vector<std::string> patterns;
  if (path.empty()) return patterns;
  std::ifstream file(path);
  if (!file)
    throw InputError({{path, 0, "", "cannot be read; name a file with the name of a row on each line"}});
  for (std::string line; std::getline(file, line);) {
    line.erase(std::min(line.find('#'), line.size()));
    line.erase(line.find_last_not_of(" \t\r") + 1);
    line.erase(0, line.find_first_not_of(" \t"));
    if (!line.empty()) patterns.push_back(line);
  }
  return patterns;
}

/// The words of a command for a shell.
std::string for_a_shell(const std::vector<std::string>& words) {
  const auto quoted = [](const std::string& word) {
    if (!word.empty() && word.find_first_of(" \t\n\"'`$\\|&;<>()*?[]#~!{}") == std::string::npos) return word;
    std::string text = "'";
    for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return text + "'";
  };
  std::vector<std::string> all;
  for (const std::string& word : words) all.push_back(quoted(word));
  return fmt::format("{}", fmt::join(all, " "));
}

conform::Plan plan_of(const ConformArguments& a) {
  conform::Plan plan;
  plan.level = a.level;
  plan.law_cases = a.law_cases > 0 ? a.law_cases : a.level == 1 ? 20 : 100;
  plan.seed = a.seed;
  plan.ops = a.ops;
  plan.strata = a.strata;
  plan.features = a.features;
  plan.scenes = a.scenes > 0 ? a.scenes : a.level == 1 ? 20 : 100;
  plan.first_scene = a.first_scene;
  plan.shrink_seconds = a.shrink_seconds;
  plan.command = for_a_shell(a.words);
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::duration<double>(a.total);
  plan.stops = [limited = a.total > 0, deadline] {
    return interrupt::requested() || (limited && std::chrono::steady_clock::now() > deadline);
  };
  plan.progress = [line = LineEvery(std::chrono::seconds(2), a.quiet)](const std::string& doing) mutable {
    if (line.due()) say("tps: asking {}\n", doing);
  };
  return plan;
}

std::string report_of(const Verdict& verdict, const ConformArguments& a) {
  if (a.format == "json") return report_json(verdict);
  if (a.format == "junit") return report_junit(verdict);
  if (a.format == "markdown") return report_markdown(verdict);
  if (a.format == "html") return report_html(verdict);
  if (a.format == "svg") return report_svg(verdict);
  return report_text(verdict, a.all);
}

/// The words of a command in one string, quoted as in shells; no shell reads them.
std::vector<std::string> words_of(const std::string& command) {
  std::vector<std::string> words = CLI::detail::split_up(command);
  for (std::string& word : words) CLI::detail::remove_quotes(word);
  words.erase(std::remove(words.begin(), words.end(), std::string()), words.end());
  if (words.empty())
    throw CLI::ValidationError("--simulator",
                               "is empty; name a command that reads a scene and writes a trace");
  return words;
}

/// What is wrong with the words of an option is a mistake of usage.
void check_words(const char* option, const std::vector<std::string>& words,
                 void (*check)(const std::vector<std::string>&)) {
  try {
    check(words);
  } catch (const std::invalid_argument& error) {
    throw CLI::ValidationError(option, error.what());
  }
}

int run_conform(const ConformArguments& a) {
  if (a.hypotheses) {
    write_result("-", fmt::format("{}\n", fmt::join(hypothesis_names(), "\n")));
    return kDone;
  }
  NamedFiles()
      .reads("--library", a.library)
      .reads("--expect-fail", a.expected)
      .reads("--profile", is_built_in(a.profile) ? "" : a.profile)
      .writes("--report", a.report)
      .require_distinct();
  check_words("--features", a.features, check_features);
  check_words("--ops", a.ops, check_operations);
  check_words("--tags", a.strata, check_strata);
  Verdict verdict;
  verdict.profile = read_profile(a.profile);
  verdict.data = fmt::format("known answers {}.{}", vectors::kVectorsVersion, vectors::kCommittedSeed);
  verdict.expected_failures = expected_failures(a.expected);
  const conform::Plan plan = plan_of(a);
  const interrupt::GoodOrder good_order;
  try {
    const auto subject = subject_of(a, verdict.profile);
    if (subject) {
      verdict.subject = subject->name();
      ask_all(*subject, plan, verdict);
    }
    if (!a.simulator.empty()) {
      verdict.subject += verdict.subject.empty() ? a.simulator : " and " + a.simulator;
      ask_simulator(command_runs(words_of(a.simulator), time_limit(a, kSecondsForARun)), plan, verdict);
    }
  } catch (const ProgramError& error) {
    say("tps: {}\n", printable_lines(error.what()));
    return kOtherProgram;
  } catch (const interrupt::Interrupted&) {
    verdict.interrupted = true;
  }
  verdict.interrupted = verdict.interrupted || interrupt::requested();
  if (!verdict.interrupted && plan.stops())
    verdict.notes["time"] = "the time given was over; what follows was not asked";
  write_result(a.report, report_of(verdict, a));
  if (a.report != "-" && !a.quiet) say("tps: {}\n", sentence(verdict));
  return exit_code(verdict);
}

void add_conform_options(CLI::App* verb, int& exit_code) {
  const auto a = std::make_shared<ConformArguments>();
  verb->add_option("command", a->words, "Behind --: a command that speaks the protocol")->transform(as_typed);
  verb->add_option("--library", a->library, "A shared library (properties/c_abi/tps_implementation.h)");
  verb->add_option("--scalar", a->scalar, "The reference itself, in this scalar")
      ->check(CLI::IsMember(reference_names()));
  verb->add_option("--simulator", a->simulator,
                   "A command that is given a scene file and writes a trace to its standard output");
  verb->add_option("--features", a->features, "What its scenes have, and have not (tps scene random --help)")
      ->delimiter(',')
      ->allow_extra_args(false);
  verb->add_option("--scenes", a->scenes, "So many scenes (default: 100; 20 at level 1)")
      ->check(integer_from(1, "a number of scenes"));
  verb->add_option("--first-scene", a->first_scene, "From this number on")
      ->check(integer_from(0, "a number of a scene"));
  verb->add_option("--ops", a->ops, "Only these operations; one that the program does not offer is REFUSED")
      ->delimiter(',')
      ->allow_extra_args(false);
  verb->add_option("--tags", a->strata,
                   "Only known answers of these strata (block_time.graze, *.far), and no laws")
      ->delimiter(',')
      ->allow_extra_args(false);
  verb->add_option("--level", a->level, "1 ten known answers a stratum, 2 those of data/vectors")
      ->check(CLI::Range(1, 2))
      ->capture_default_str();
  verb->add_option("--cases", a->law_cases, "Cases of each law (default: 100; 20 at level 1)")
      ->check(integer_from(1, "a number of cases"));
  verb->add_option("--seed", a->seed, "Which cases of the laws")->check(integer_from(0, "a seed"));
  verb->add_option("--profile", a->profile,
                   "certified, double-stable, double-paper, float, or a file (docs/conform.md)")
      ->capture_default_str();
  verb->add_option("--expect-fail", a->expected, "A file of rows that may fail, and must");
  verb->add_option("--bits", a->bits, "Significant bits of its numbers: 53 for double, 24 for float")
      ->check(CLI::Range(8, 400));
  verb->add_option("--timeout", a->timeout, "Seconds for a reply (default: 5), and for a run (10)")
      ->check(number_from(0.001, 3600, "a time limit in seconds"));
  verb->add_option("--total-seconds", a->total, "Seconds for everything")
      ->check(number_from(0, 1e6, "a time limit in seconds"));
  verb->add_option("--shrink-seconds", a->shrink_seconds,
                   "Seconds for making cases of broken laws simpler, in all")
      ->check(number_from(0, 3600, "a time limit in seconds"))
      ->capture_default_str();
  verb->add_option("--report", a->report, "Where the report goes")->capture_default_str();
  verb->add_option("--format", a->format)
      ->check(CLI::IsMember({"text", "json", "junit", "markdown", "html", "svg"}))
      ->capture_default_str();
  verb->add_flag("--all", a->all, "Every row, not only those with something to tell");
  verb->add_flag("--hypotheses", a->hypotheses, "Lists the mistakes that wrong answers are compared with");
  verb->add_flag("--quiet", a->quiet, "No progress");
  verb->footer(kConformFooter);
  verb->callback([=, &exit_code] { exit_code = run_conform(*a); });
}

}  // namespace

void add_conform(CLI::App& app, int& exit_code) {
  CLI::App* verb = app.add_subcommand("conform", "One verdict on an implementation in any language.");
  make_when_called(verb, [&exit_code](CLI::App* called) { add_conform_options(called, exit_code); });
  make_when_called(app.get_subcommand("scene"), [](CLI::App* scene) { add_random_scene(*scene); });
}

}  // namespace tps::cli
