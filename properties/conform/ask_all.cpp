#include "properties/conform/ask_all.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

#include "properties/conform/ask_runs.hpp"
#include "properties/conform/ask_steps.hpp"
#include "properties/conform/random_scene.hpp"
#include "properties/implementations/program.hpp"

namespace tps::properties::conform {
namespace {

/// What hello says of its questions is added to the plan.
Plan within_capabilities(const Implementation& subject, const Plan& plan, Verdict& verdict) {
  Plan taken = plan;
  const std::vector<std::string> features = subject.features();
  if (features.empty()) return taken;
  try {
    check_features(features);
  } catch (const std::invalid_argument& error) {
    throw ProgramError(fmt::format("{}: features in the answer to hello: {}", subject.name(), error.what()));
  }
  verdict.notes["says what it takes"] =
      fmt::format("{}; other questions were not asked", fmt::join(features, ", "));
  taken.features.insert(taken.features.begin(), features.begin(), features.end());
  return taken;
}

/// States of scenes are doubles.
constexpr int kBitsOfStates = 53;

void ask_next_events(Implementation& subject, const Plan& plan, Verdict& verdict) {
  if (!is_offered(subject, verdict, Op::next_event)) return;
  if (!wanted(plan.ops, std::string(operations::name(Op::next_event))) ||
      subject.format().bits < kBitsOfStates)
    return;
  const auto rows = step_rows();
  if (std::none_of(rows.begin(), rows.end(),
                   [&](const std::string& row) { return wanted(plan.strata, row); }))
    return;
  StepPlan steps;
  steps.features = plan.features;
  if (plan.level == 1) steps.scenes = steps.steps = 10;
  steps.is_asked = [&plan](const std::string& row) { return wanted(plan.strata, row); };
  steps.commands_of = [&plan](const Question& question) { return plan.commands_of(question); };
  steps.stops = plan.stops;
  steps.progress = plan.progress;
  ask_steps(subject, steps, verdict);
}

/// An operation that --ops names, and that the subject does not offer, is refused.
void refuse_what_is_asked_for(const Implementation& subject, const Plan& plan, Verdict& verdict) {
  for (const std::string& name : plan.ops) {
    const operations::Operation* operation = operations::find(name);
    if (operation == nullptr) continue;  // a pattern
    if (is_offered(subject, verdict, operation->op)) continue;
    std::erase(verdict.not_offered, name);
    Row row = row_of(operation->op, "offered");
    row.add({Class::refused, "asked for by --ops, and not offered"}, [&] {
      return Example{Class::refused, name, {}, {}, {}};
    });
    verdict.rows.push_back(std::move(row));
  }
}

bool simulates(const Implementation& subject, const Plan& plan) {
  const std::string simulate(operations::name(Op::simulate));
  return subject.offered() && subject.may_offer(Op::simulate) && plan.strata.empty() &&
         (plan.ops.empty() || has(plan.ops, simulate));
}

}  // namespace

void ask_simulator(RunSource source, const Plan& plan, Verdict& verdict) {
  RunPlan runs;
  runs.source = std::move(source);
  runs.features = plan.features;
  runs.scenes = plan.scenes;
  runs.first = plan.first_scene;
  runs.stops = plan.stops;
  runs.progress = plan.progress;
  ask_runs(runs, verdict);
}

void ask_all(Implementation& subject, const Plan& plan, Verdict& verdict) {
  const Plan taken = within_capabilities(subject, plan, verdict);
  ask_known_answers(subject, taken, verdict);
  ask_next_events(subject, taken, verdict);
  if (plan.strata.empty()) ask_laws(subject, taken, verdict);
  const auto command_of = [&plan](const Question& question) {
    const std::vector<std::string> commands = plan.commands_of(question);
    return commands.size() > 1 ? commands.back() : std::string();  // a library is asked by no command
  };
  if (simulates(subject, taken)) ask_simulator(operation_runs(subject, command_of), taken, verdict);
  refuse_what_is_asked_for(subject, taken, verdict);
  if (const std::string why = subject.given_up(); !why.empty())
    verdict.notes["given up"] = why + "; what follows was not asked";
}

}  // namespace tps::properties::conform
