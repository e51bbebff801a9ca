// tps cost
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>

#include "properties/cost/foreign_variant.hpp"
#include "properties/implementations/program.hpp"
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
#include "verify/cost/questions.hpp"
#include "verify/cost/wanted.hpp"
#include "verify/cost/whole_study.hpp"

namespace tps::cli {
namespace {

using namespace tps::cost;

/// What was asked for; absent where nothing was said.
struct CostArguments {
  StudyPlan plan;
  std::vector<std::string> variants, words;
  std::optional<int> questions, repetitions;
  std::optional<std::uint64_t> seed, events;
  std::string from, json, csv, page, format = "text";
  bool queries = false, responses = false, runs = false, model = false, cases = false;
  bool quick = false, without_times = false, quiet = false;
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

/// The baseline is always among them, since ratios are taken against it.
std::vector<Variant> wanted_variants(const std::vector<std::string>& names,
                                     const std::vector<std::string>& words) {
  std::vector<Variant> result;
  for (const Variant& variant : variants()) {
    if (variant.name == kBaseline || is_wanted(names, variant.name)) result.push_back(variant);
  }
  if (!words.empty()) result.push_back(properties::foreign_variant(words));
  return result;
}

/// The study as an earlier, interrupted call has left it; its settings must be these.
Json resumed(const std::string& path, Json fresh) {
  if (path.empty() || path == "-" || !std::filesystem::exists(path)) return fresh;
  Json stored = read_study(path);
  const std::string difference = difference_of_plans(stored, fresh);
  if (!difference.empty()) {
    throw InputError(
        {{path, 0, difference, "is of another study; remove the file, or name another one by --json"}});
  }
  adopt_levels(stored, fresh);
  return stored;
}

Json measured(const CostArguments& a) {
  Json study = resumed(a.json, planned(a.plan, this_machine()));
  const Announce announce = [&](const std::string& what) {
    if (may_say_progress(a.quiet)) say("tps: {}\n", what);
    interrupt::check();
  };
  measure_study(a.plan, study, announce, [&](const Json& so_far) {
    if (!a.json.empty() && a.json != "-") write_result(a.json, study_text(so_far));
  });
  return study;
}

/// A choice that only one level heeds.
struct Choice {
  const char* option;
  Level level;
};
constexpr Choice kChoices[] = {{"--variant", Level::queries},     {"--stratum", Level::queries},
                               {"--repetitions", Level::queries}, {"--without-times", Level::queries},
                               {"command", Level::queries},       {"--events", Level::runs},
                               {"--case", Level::cases}};

/// The levels that are named or, where none is, those that the choices are about; without either all.
std::vector<Level> levels_of(const CLI::App& verb, const CostArguments& a) {
  std::set<Level> levels;
  if (a.queries) levels.insert(Level::queries);
  if (a.responses) levels.insert(Level::responses);
  if (a.runs) levels.insert(Level::runs);
  if (a.model) levels.insert(Level::model);
  if (a.cases) levels.insert(Level::cases);
  const bool is_named = !levels.empty();
  const auto settle = [&](const char* option, std::initializer_list<Level> heeded_by) {
    if (verb.count(option) == 0) return;
    if (!is_named) levels.insert(heeded_by);
    const bool is_heeded =
        std::any_of(heeded_by.begin(), heeded_by.end(), [&](Level level) { return levels.contains(level); });
    if (!is_heeded) {
      throw CLI::ValidationError(
          fmt::format("{} changes nothing of the levels that are named; leave one of the two out", option));
    }
  };
  for (const Choice& choice : kChoices) settle(choice.option, {choice.level});
  settle("--scene", {Level::runs, Level::model});
  if (is_named) {
    settle("--questions", {Level::queries, Level::responses});
    settle("--seed", {Level::queries, Level::responses, Level::runs, Level::model});  // hard cases are fixed
  }
  if (levels.empty()) {
    return {Level::queries, Level::responses, Level::runs, Level::model, Level::cases};
  }
  return {levels.begin(), levels.end()};
}

/// The plan with what was said put into it.
void settle_plan(const CLI::App& verb, CostArguments& a) {
  StudyPlan plan = a.quick ? quick_plan() : full_plan();
  plan.strata = a.plan.strata;
  plan.scenes = a.plan.scenes;
  plan.cases = a.plan.cases;
  plan.with_times = !a.without_times;
  plan.levels = levels_of(verb, a);
  plan.variants = wanted_variants(a.variants, a.words);  // starts a command
  plan.questions.seed = a.seed.value_or(plan.questions.seed);
  plan.questions.repetitions = a.repetitions.value_or(plan.questions.repetitions);
  plan.questions.questions = a.questions.value_or(plan.questions.questions);
  plan.response_questions = a.questions.value_or(plan.response_questions);
  plan.events = a.events.value_or(plan.events);
  a.plan = plan;
}

constexpr const char* kCostFooter =
    R"(One study, one page: single questions (eq. 2, on the strata of the known answers, against the exact answer), responses (eqs. 4, 5, 7),
whole runs, the model's own numbers, hard cases; or those levels alone that are named (docs/accuracy-cost.md). Times are of this thread's
CPU; nothing is decided by them. With --json FILE a call that was interrupted goes on where the file ends.
Examples: tps cost --quick --page cost.html
          tps cost --json cost.json --page cost.html
          tps cost --quick --stratum graze --variant stable-double,certified-time
          tps cost --from cost.json --page cost.html
          tps cost --quick --variant stable-double --page mine.html -- python3 mine.py
          tps cost --runs --scene gas --events 500
          tps cost --hard-cases --case grazing-train)";

void run_cost(const CostArguments& a) {
  NamedFiles()
      .reads("--from", a.from)
      .writes("--json", a.json)
      .writes("--csv", a.csv)
      .writes("--page", a.page)
      .require_distinct();
  const Json study = a.from.empty() ? measured(a) : read_study(a.from);
  if (!a.json.empty()) write_result(a.json, study_text(study));
  if (!a.csv.empty()) write_result(a.csv, report_csv(study));
  if (!a.page.empty()) write_result(a.page, report_page(study));
  if (a.json != "-" && a.csv != "-" && a.page != "-") {
    write_result("-", a.format == "json" ? study_text(study) : report_text(study));
  }
}

constexpr const char* kLevels[] = {"--queries", "--responses", "--runs", "--model", "--hard-cases"};

void add_levels(CLI::App& verb, CostArguments& a) {
  verb.add_flag("--queries", a.queries,
                "Single questions: the time of eq. (2), each variant on each stratum");
  verb.add_flag("--responses", a.responses, "Eqs. (4), (5) and (7) in each scalar, against enclosures");
  verb.add_flag("--runs", a.runs,
                "Whole runs: events a second, drift, horizon in each scalar and timing; what is proven");
  verb.add_flag("--model", a.model, "The model's own numbers: dt_restitute and theta_revolve");
  verb.add_flag("--hard-cases", a.cases, "Hard cases by name, and which arithmetic is good enough for each");
}

/// A list of names behind an option.
void add_names(CLI::App& verb, const char* option, std::vector<std::string>& to, const char* what,
               const std::vector<std::string>& all) {
  verb.add_option(option, to, what)->delimiter(',')->allow_extra_args(false)->check(CLI::IsMember(all));
}

void add_choices(CLI::App& verb, CostArguments& a) {
  add_names(verb, "--variant", a.variants, "Only these ways to compute", variant_names());
  add_names(verb, "--stratum", a.plan.strata, "Only these strata (tps vectors list)", stratum_names());
  add_names(verb, "--scene", a.plan.scenes, "Only these scenes of --runs and --model", study_scenes());
  add_names(verb, "--case", a.plan.cases, "Only these hard cases", names_of_cases());
  verb.add_option("--questions", a.questions,
                  "Questions of each stratum (default: 50000; 2000 if quick; 200 and 20 of responses)")
      ->check(CLI::Range(1, 10'000'000));
  verb.add_option("--repetitions", a.repetitions,
                  "Repetitions of each loop of single questions (default: 31; 9 if quick)")
      ->check(CLI::Range(1, 10'000));
  verb.add_option("--events", a.events, "Events of each of the runs, at most (default: 3000; 800 if quick)")
      ->check(integer_from(1, "a number of events"));
  verb.add_option("--seed", a.seed, "Which questions, which start of the gas")
      ->check(integer_from(0, "a seed"));
  verb.add_flag("--without-times", a.without_times,
                "Verdicts and errors of single questions only: the same on every machine");
}

void add_outputs(CLI::App& verb, CostArguments& a) {
  CLI::Option* const from =
      verb.add_option("--from", a.from, "Shows a stored study (JSON) instead of measuring");
  for (const char* level : kLevels) from->excludes(level);
  verb.add_option("--json", a.json, "Where the study goes as JSON (data/schemas/cost.schema.json)");
  verb.add_option("--csv", a.csv, "Where it goes as CSV");
  verb.add_option("--page", a.page, "Where it goes as a page with figures");
  verb.add_option("--format", a.format, "Of what is printed")
      ->check(CLI::IsMember({"text", "json"}))
      ->capture_default_str();
  verb.add_flag("--quiet", a.quiet, "No progress");
}

void add_cost_options(CLI::App* verb, int& exit_code) {
  const auto a = std::make_shared<CostArguments>();
  verb->add_flag("--quick", a->quick, "Much less of everything: a minute");
  add_levels(*verb, *a);
  add_choices(*verb, *a);
  add_outputs(*verb, *a);
  verb->add_option("command", a->words,
                   "Behind --: a program of yours that speaks the protocol, measured beside ours")
      ->transform(as_typed)
      ->excludes("--from");
  verb->footer(kCostFooter);
  verb->callback([=, &exit_code] {
    if (a->words.empty() ? command_line_has_dashes() : a->words[0].empty()) {
      throw CLI::ValidationError("nothing stands behind --; name a command there, or leave -- out");
    }
    try {
      if (a->from.empty()) settle_plan(*verb, *a);
      run_cost(*a);
      exit_code = kDone;
    } catch (const properties::ProgramError& error) {
      say("tps: {}\n", printable_lines(error.what()));
      exit_code = kOtherProgram;
    }
  });
}

}  // namespace

void add_cost(CLI::App& app, int& exit_code) {
  CLI::App* verb = app.add_subcommand("cost", "What accuracy costs in time.");
  make_when_called(verb, [&exit_code](CLI::App* called) { add_cost_options(called, exit_code); });
}

}  // namespace tps::cli
