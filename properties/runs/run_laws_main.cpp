// Asks the laws of runs, of the reference or of any command that simulates as `tps run` does.
#include <rapidcheck.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <iostream>
#include <random>

#include "properties/runs/hazards.hpp"
#include "properties/runs/laws.hpp"
#include "properties/runs/trace_check_instead.hpp"
#include "reference/process/descriptors.hpp"
#include "reference/process/interrupt.hpp"

namespace tps::properties::runs {
namespace {

struct Options {
  bool list = false, list_hazards = false;
  std::string scalar = "double", timing = "stable", only;
  int cases = 100;
  std::uint64_t seed = 0;
  double timeout = static_cast<double>(kTimeOfARun.count()) / 1000;
  std::vector<std::string> command;
};

void print_laws() {
  std::cout << "| | name | law | page |\n|---|---|---|---|\n";
  for (const RunLaw& law : run_laws()) {
    const std::string page = law.page.substr(law.page.find('/') + 1);
    std::cout << "| " << law.number << " | `" << law.name << "` | " << law.sentence << " | [" << page << "]("
              << page << ") |\n";
  }
}

void print_hazards() {
  std::cout << "| hazard | meaning | of 1000 scenes, at least |\n|---|---|---|\n";
  for (const HazardFloor& floor : hazard_floors())
    std::cout << "| " << floor.name << " | " << floor.meaning << " | " << floor.in_a_thousand << " |\n";
}

bool is_asked(const RunLaw& law, const Options& options) {
  const bool held_by_judge =
      options.scalar == "float" || options.scalar == "double" || options.scalar == "long-double";
  if (!options.only.empty() && options.only != law.name) return false;
  if (law.needs_exact_timing && options.timing == "paper") return false;
  return law.compares_runs || held_by_judge;
}

/// Prints what became of a law; whether it holds.
bool ask(const RunLaw& law, Simulator& simulator, const Options& options) {
  rc::detail::TestParams params;
  params.seed = options.seed;
  params.maxSuccess = options.cases;
  Instead instead = check_instead();
  const rc::detail::TestResult result =
      rc::detail::checkTestable([&] { check_law(law, simulator, 0, &instead); },
                                rc::detail::TestMetadata{law.name, law.sentence}, params);
  std::cout << "law " << law.number << " " << law.name << ": ";
  rc::detail::printResultMessage(result, std::cout);
  std::cout << "\n";
  if (instead.traces > 0) {
    std::cout << "  not judged: the law cannot judge minimal traces; the check judged " << instead.traces
              << " of them instead\n";
  }
  return !result.is<rc::detail::FailureResult>();
}

std::chrono::milliseconds time_limit(const Options& options) {
  return std::chrono::milliseconds(static_cast<std::int64_t>(options.timeout * 1000));
}

/// CLI11's own range lets nan through.
std::string time_of_a_run(const std::string& text) {
  double seconds = 0;
  if (CLI::detail::lexical_cast(text, seconds) && seconds >= 0.001 && seconds <= 86'400) return {};
  return "'" + text + "' is no time limit; allowed are seconds from 0.001 to 86400";
}

/// "--" and no command, or an empty one: the reference must not be asked, and praised, instead.
bool nothing_behind_dashes(int argc, char** argv, const Options& options) {
  const bool dashes =
      std::any_of(argv, argv + argc, [](const char* word) { return std::string(word) == "--"; });
  return (dashes && options.command.empty()) || (!options.command.empty() && options.command[0].empty());
}

int run(const Options& options) {
  const auto simulator = options.command.empty() ? reference_simulator(options.scalar, options.timing)
                                                 : command_simulator(options.command, options.scalar,
                                                                     options.timing, time_limit(options));
  std::cout << "seed " << options.seed << "\n";
  bool all = true;
  for (const RunLaw& law : run_laws()) {
    if (is_asked(law, options)) all = ask(law, *simulator, options) && all;
  }
  return all ? 0 : 1;
}

}  // namespace
}  // namespace tps::properties::runs

int main(int argc, char** argv) {
  using namespace tps::properties::runs;
  tps::occupy_standard_descriptors();
  tps::interrupt::install("tps_run_laws");
  Options options;
  options.seed = std::random_device{}();
  CLI::App app{
      "Laws of whole runs, asked of the reference or of COMMAND, which takes the options of `tps run`.\n"
      "Example: tps_run_laws --cases 20 --seed 1 -- ./my_simulator run"};
  app.add_flag("--list", options.list, "the laws, as a table");
  app.add_flag("--hazards", options.list_hazards, "what generated scenes meet, as a table");
  app.add_option("--law", options.only, "one law, by its name");
  app.add_option("--scalar", options.scalar)
      ->check(CLI::IsMember({"float", "double", "long-double", "quad", "mp50", "mp100"}));
  app.add_option("--timing", options.timing)->check(CLI::IsMember({"paper", "stable", "certified"}));
  app.add_option("--cases", options.cases, "generated scenes a law")->check(CLI::Range(1, 1000000));
  app.add_option("--seed", options.seed, "repeats a search; printed by every one");
  app.add_option("--timeout", options.timeout, "seconds for each run of COMMAND")
      ->check(CLI::Validator(time_of_a_run, "SECONDS"))
      ->capture_default_str();
  app.add_option("command", options.command, "the program to ask, behind --");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  if (nothing_behind_dashes(argc, argv, options)) {
    std::cerr << "tps_run_laws: nothing stands behind --; name a command there\n";
    return 2;
  }
  try {
    if (options.list) print_laws();
    if (options.list_hazards) print_hazards();
    return options.list || options.list_hazards ? 0 : run(options);
  } catch (const std::exception& error) {
    std::cerr << "tps_run_laws: " << error.what() << "\n";
    return 4;
  }
}
