// tps cost
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>

#include "properties/cost/foreign_variant.hpp"
#include "properties/implementations/program.hpp"
#include "reference/process/interrupt.hpp"
#include "reference/text/input_error.hpp"
#include "reference/text/printable.hpp"
#include "verify/cli/named_files.hpp"
#include "verify/cli/numbers.hpp"
#include "verify/cli/say.hpp"
#include "verify/cli/verbs.hpp"
#include "verify/cli/write_result.hpp"
#include "verify/cost/levels.hpp"
#include "verify/cost/measure.hpp"

namespace tps::cli {
namespace {

using namespace tps::cost;

struct CostArguments {
  StudyOptions options;
  std::vector<std::string> variants, strata, case_names, words;
  std::optional<int> questions_given;
  std::uint64_t events = 3000;  // of each run of --runs, at most
  std::string from, json, csv, page, format = "text";
  bool responses = false, runs = false, model = false, cases = false, quick = false, without_times = false,
       quiet = false;

  bool is_of_questions() const { return !responses && !runs && !model && !cases; }
};

std::vector<std::string> variant_names() {
  std::vector<std::string> names;
  for (const Variant& variant : variants()) names.push_back(variant.name);
  return names;
}

std::vector<std::string> stratum_names() {
  std::vector<std::string> names;
  for (const Hazard& hazard : hazards()) names.push_back(hazard.name);
  return names;
}

std::vector<std::string> names_of_cases() {
  std::vector<std::string> names;
  for (const HardCase& one : hard_cases()) names.push_back(one.name);
  return names;
}

bool wanted(const std::vector<std::string>& names, const std::string& name) {
  return names.empty() || std::find(names.begin(), names.end(), name) != names.end();
}

/// The baseline is always among them, since ratios are taken against it.
std::vector<Variant> wanted_variants(const std::vector<std::string>& names,
                                     const std::vector<std::string>& words) {
  std::vector<Variant> result;
  for (const Variant& variant : variants()) {
    if (variant.name == kBaseline || wanted(names, variant.name)) result.push_back(variant);
  }
  if (!words.empty()) result.push_back(properties::foreign_variant(words));
  return result;
}

/// The strata that a file of an earlier, interrupted call has; its settings and variants must be these.
Json resumed(const std::string& path, const Json& fresh) {
  if (path.empty() || path == "-" || !std::filesystem::exists(path)) return fresh;
  const Json stored = read_study(path);
  for (const char* key : {"settings", "formulas", "variants", "machine"}) {
    if (stored.at(key) != fresh.at(key)) {
      throw InputError({{path, 0, std::string("/") + key,
                         "is of another study; remove the file, or name another one by --json"}});
    }
  }
  return stored;
}

bool has_stratum(const Json& study, const std::string& name) {
  const Json& strata = study.at("strata");
  return std::any_of(strata.begin(), strata.end(), [&](const Json& s) { return s.at("name") == name; });
}

Json measured(const CostArguments& a) {
  const std::vector<Variant> chosen = wanted_variants(a.variants, a.words);
  Json study = resumed(a.json, study_json(a.options, chosen, this_machine()));
  for (const Hazard& hazard : hazards()) {
    if (!wanted(a.strata, hazard.name) || has_stratum(study, hazard.name)) continue;
    if (!a.quiet) say("tps: {} ({} of {})\n", hazard.name, study.at("strata").size() + 1, hazards().size());
    StratumResult result = measure_accuracy(hazard, a.options, chosen);
    if (!a.without_times) measure_times(result, a.options, chosen);
    study["strata"].push_back(stratum_json(result));
    if (!a.json.empty() && a.json != "-") write_result(a.json, study_text(study));
    if (interrupt::requested()) throw interrupt::Interrupted();
  }
  return study;
}

/// A level above single questions.
Json measured_level(const CostArguments& a) {
  const Announce announce = [&](const std::string& what) {
    if (!a.quiet) say("tps: {}\n", what);
    interrupt::check();
  };
  if (a.cases) {
    std::vector<CaseResult> results;
    for (const HardCase& one : hard_cases()) {
      if (!wanted(a.case_names, one.name)) continue;
      announce(one.name);
      results.push_back(measure_case(one));
    }
    return cases_json(results, this_machine());
  }
  if (a.responses) {
    ResponseLevelOptions options;
    options.seed = a.options.seed;
    options.questions = a.questions_given.value_or(options.questions);
    options.announce = announce;
    return responses_json(measure_responses(options), this_machine());
  }
  if (a.model) return model_json(measure_model({a.options.seed, announce}), this_machine());
  RunLevelOptions options;
  options.seed = a.options.seed;
  options.events = a.events;
  options.announce = announce;
  return runs_json(measure_runs(options), this_machine());
}

constexpr const char* kCostFooter =
    R"(Measures ways to compute the time of eq. (2), on the strata of the known answers, against the exact answer: nanoseconds
a question, wrong verdicts, error of the time (docs/accuracy-cost.md). Times are of this thread's CPU; nothing is decided by them.
With --json FILE a call that was interrupted goes on where the file ends.
Examples: tps cost --quick --page cost.html
          tps cost --quick --stratum graze --variant stable-double,certified-time
          tps cost --from cost.json --page cost.html
          tps cost --quick --variant stable-double --page mine.html -- python3 mine.py
          tps cost --responses --csv responses.csv
          tps cost --runs --page runs.html
          tps cost --model --csv model.csv
          tps cost --hard-cases)";

/// Tells more than --quick asks: rates of ten in a million show, and intervals are narrow.
constexpr StudyOptions kFull{1, 50'000, 1024, 31};

void run_cost(const CostArguments& a) {
  NamedFiles()
      .reads("--from", a.from)
      .writes("--json", a.json)
      .writes("--csv", a.csv)
      .writes("--page", a.page)
      .require_distinct();
  const Json study = !a.from.empty()       ? read_study(a.from)
                     : a.is_of_questions() ? measured(a)
                                           : measured_level(a);
  if (!a.json.empty()) write_result(a.json, study_text(study));
  if (!a.csv.empty()) write_result(a.csv, report_csv(study));
  if (!a.page.empty()) write_result(a.page, report_page(study));
  if (a.json != "-" && a.csv != "-" && a.page != "-") {
    write_result("-", a.format == "json" ? study_text(study) : report_text(study));
  }
}

/// Levels instead of single questions, with the same outputs. What would change only the questions is refused
/// beside them.
void add_levels(CLI::App& verb, CostArguments& a) {
  CLI::Option* const levels[] = {
      verb.add_flag("--responses", a.responses,
                    "Responses instead: eqs. (4), (5) and (7) in each scalar, against enclosures"),
      verb.add_flag("--runs", a.runs,
                    "Whole runs instead: events a second, drift, horizon, in each scalar and timing"),
      verb.add_flag("--model", a.model, "The model's own numbers instead: dt_restitute and theta_revolve"),
      verb.add_flag("--hard-cases", a.cases,
                    "Hard cases instead, by name, and which arithmetic is good enough for each")};
  for (CLI::Option* const level : levels) {
    for (const char* other :
         {"--variant", "--stratum", "--questions", "--repetitions", "--without-times", "--quick"}) {
      const bool has_questions = level == levels[0] && std::string_view(other) == "--questions";
      if (!has_questions) level->excludes(verb.get_option(other));
    }
    for (CLI::Option* const another : levels) {
      if (another != level) level->excludes(another);
    }
  }
  levels[3]->excludes(verb.get_option("--seed"));  // its scenes are fixed
  verb.add_option("--events", a.events, "Events of each of the runs, at most")
      ->check(integer_from(1, "a number of events"))
      ->capture_default_str()
      ->needs(levels[1]);
  verb.add_option("--case", a.case_names, "Only these hard cases")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::IsMember(names_of_cases()))
      ->needs(levels[3]);
}

}  // namespace

void add_cost(CLI::App& app, int& exit_code) {
  const auto a = std::make_shared<CostArguments>();
  CLI::App* verb = app.add_subcommand("cost", "What accuracy costs in time.");
  verb->add_flag("--quick", a->quick, "Fewer questions and repetitions: a minute");
  verb->add_option("--variant", a->variants, "Only these ways to compute")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::IsMember(variant_names()));
  verb->add_option("--stratum", a->strata, "Only these strata (tps vectors list)")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::IsMember(stratum_names()));
  verb->add_option("--questions", a->options.questions,
                   "Questions of each stratum (default: 50000; 2000; 200 of responses)")
      ->check(CLI::Range(1, 10'000'000));
  verb->add_option("--repetitions", a->options.repetitions, "Repetitions of each loop (default: 31; 9)")
      ->check(CLI::Range(1, 10'000));
  verb->add_option("--seed", a->options.seed, "Which questions")->check(integer_from(0, "a seed"));
  verb->add_flag("--without-times", a->without_times, "Verdicts and errors only: the same on every machine");
  add_levels(*verb, *a);
  verb->add_option("--from", a->from, "Shows a stored study (JSON) instead of measuring")
      ->excludes("--responses")
      ->excludes("--runs")
      ->excludes("--model")
      ->excludes("--hard-cases");
  verb->add_option("--json", a->json, "Where the study goes as JSON (data/schemas/cost.schema.json)");
  verb->add_option("--csv", a->csv, "Where it goes as CSV");
  verb->add_option("--page", a->page, "Where it goes as a page with figures");
  verb->add_option("--format", a->format, "Of what is printed")
      ->check(CLI::IsMember({"text", "json"}))
      ->capture_default_str();
  verb->add_flag("--quiet", a->quiet, "No progress");
  CLI::Option* const words = verb->add_option(
      "command", a->words, "Behind --: a program of yours that speaks the protocol, measured beside ours");
  for (const char* level : {"--responses", "--runs", "--model", "--hard-cases", "--from"}) {
    words->excludes(verb->get_option(level));
  }
  verb->footer(kCostFooter);
  verb->callback([=, &exit_code] {
    const StudyOptions given = a->options;
    StudyOptions defaults = a->quick ? StudyOptions{} : kFull;
    if (verb->count("--questions") > 0) {
      defaults.questions = given.questions;
      a->questions_given = given.questions;
    }
    if (verb->count("--repetitions") > 0) defaults.repetitions = given.repetitions;
    defaults.seed = given.seed;
    a->options = defaults;
    if (a->words.empty() ? command_line_has_dashes() : a->words[0].empty()) {
      throw CLI::ValidationError("nothing stands behind --; name a command there, or leave -- out");
    }
    try {
      run_cost(*a);
      exit_code = kDone;
    } catch (const properties::ProgramError& error) {
      say("tps: {}\n", printable_lines(error.what()));
      exit_code = kOtherProgram;
    }
  });
}

}  // namespace tps::cli
