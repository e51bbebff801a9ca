#include "properties/cli/ask_run_laws.hpp"

#include <fmt/format.h>
#include <fnmatch.h>
#include <rapidcheck.h>

#include <algorithm>
#include <memory>
#include <sstream>
#include <utility>

#include "properties/runs/hazards.hpp"
#include "properties/runs/laws.hpp"
#include "properties/runs/trace_check_instead.hpp"
#include "reference/text/printable.hpp"
#include "verify/cli/say.hpp"
#include "verify/cli/verbs.hpp"
#include "verify/cli/write_result.hpp"

namespace tps::cli {
namespace {

namespace runs = properties::runs;

bool is_called(const runs::RunLaw& law, const std::vector<std::string>& patterns) {
  return patterns.empty() || std::any_of(patterns.begin(), patterns.end(), [&](const std::string& pattern) {
           return ::fnmatch(pattern.c_str(), law.name.c_str(), 0) == 0 ||
                  std::to_string(law.number) == pattern;
         });
}

/// Whether a law can be judged of runs in this scalar and timing.
bool can_be_judged(const runs::RunLaw& law, const RunLawQuestions& questions) {
  const bool judge_holds_scalar =
      questions.scalar == "float" || questions.scalar == "double" || questions.scalar == "long-double";
  if (law.needs_exact_timing && questions.timing == "paper") return false;
  return law.compares_runs || judge_holds_scalar;
}

/// Remembers whether the command failed: RapidCheck takes its exception for a broken law.
class Watched final : public runs::Simulator {
  template <typename Call>
  auto noting(const Call& call) {
    try {
      return call();
    } catch (const std::runtime_error&) {
      failed_ = true;
      throw;
    }
  }

 public:
  explicit Watched(std::unique_ptr<runs::Simulator> watched) : watched_(std::move(watched)) {}
  std::string name() const override { return watched_->name(); }
  std::string scalar() const override { return watched_->scalar(); }
  std::string timing() const override { return watched_->timing(); }
  std::vector<std::string> detectors() const override { return watched_->detectors(); }
  std::string simulate(const Scene& scene, const runs::Extent& extent) override {
    return noting([&] { return watched_->simulate(scene, extent); });
  }
  std::optional<std::string> go_on(const std::string& beginning, const runs::Extent& extent) override {
    return noting([&] { return watched_->go_on(beginning, extent); });
  }
  bool failed() const { return failed_; }

 private:
  std::unique_ptr<runs::Simulator> watched_;
  bool failed_ = false;
};

/// Prints what became of a law; whether it holds.
bool ask(const runs::RunLaw& law, runs::Simulator& simulator, const RunLawQuestions& questions) {
  rc::detail::TestParams params;
  params.seed = questions.seed;
  params.maxSuccess = static_cast<int>(std::min<std::uint64_t>(questions.cases, 1U << 30U));
  runs::Instead instead = runs::check_instead();
  const rc::detail::TestResult result =
      rc::detail::checkTestable([&] { runs::check_law(law, simulator, 0, &instead); },
                                rc::detail::TestMetadata{law.name, law.sentence}, params);
  std::ostringstream said;
  rc::detail::printResultMessage(result, said);
  rc::detail::GaveUpResult gave_up;
  const bool never_asked = result.match(gave_up) && gave_up.numSuccess == 0;
  std::string text =
      fmt::format("law {} {}: {}\n", law.number, law.name,
                  never_asked ? "not asked: no scene that was generated can ask it of this simulator"
                              : printable_lines(said.str()));
  if (instead.traces > 0) {
    text += fmt::format(
        "  not judged: the law cannot judge minimal traces; the check judged {} of them instead\n",
        instead.traces);
  }
  write_result("-", text);
  return !result.is<rc::detail::FailureResult>();
}

}  // namespace

std::string table_of_run_laws() {
  std::string table = "| | name | law | page |\n|---|---|---|---|\n";
  for (const runs::RunLaw& law : runs::run_laws()) {
    const std::string page = law.page.substr(law.page.find('/') + 1);
    table += fmt::format("| {} | `{}` | {} | [{}]({}) |\n", law.number, law.name, law.sentence, page, page);
  }
  return table;
}

std::string table_of_hazards() {
  std::string table = "| hazard | meaning | of 1000 scenes, at least |\n|---|---|---|\n";
  for (const runs::HazardFloor& floor : runs::hazard_floors())
    table += fmt::format("| {} | {} | {} |\n", floor.name, floor.meaning, floor.in_a_thousand);
  return table;
}

int ask_run_laws(const RunLawQuestions& questions) {
  std::vector<const runs::RunLaw*> called, asked;
  for (const runs::RunLaw& law : runs::run_laws()) {
    if (!is_called(law, questions.patterns)) continue;
    called.push_back(&law);
    if (can_be_judged(law, questions)) asked.push_back(&law);
  }
  if (called.empty()) {
    throw CLI::ValidationError(
        fmt::format("no law of runs is called {}; tps properties --runs --list shows names and numbers",
                    fmt::join(questions.patterns, " ")));
  }
  Watched simulator(questions.command.empty() ? runs::reference_simulator(questions.scalar, questions.timing)
                                              : runs::command_simulator(questions.command, questions.scalar,
                                                                        questions.timing, questions.timeout));
  write_result("-", fmt::format("seed {}\n", questions.seed));
  bool all_hold = true;
  for (const runs::RunLaw* law : asked) all_hold = ask(*law, simulator, questions) && all_hold;
  if (asked.empty()) {
    say("tps: laws that judge numbers are asked of float, double and long-double, those of exact distances "
        "not "
        "of paper timing: nothing was asked\n");
    return kUndecided;
  }
  if (simulator.failed() && !questions.command.empty()) return kOtherProgram;
  return all_hold ? kDone : kViolation;
}

}  // namespace tps::cli
