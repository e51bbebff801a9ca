#include "verify/cost/whole_study.hpp"

#include <algorithm>

#include "reference/process/interrupt.hpp"
#include "verify/cost/measure.hpp"
#include "verify/cost/wanted.hpp"

namespace tps::cost {
namespace {

std::string key_of(Level level) {
  switch (level) {
    case Level::queries:
      return "strata";
    case Level::responses:
      return "responses";
    case Level::runs:
      return "runs";
    case Level::model:
      return "model";
    case Level::cases:
      return "cases";
  }
  return {};
}

/// The parts of a level that a plan wants.
std::vector<std::string> parts_of(Level level, const StudyPlan& plan) {
  std::vector<std::string> all;
  const std::vector<std::string>* chosen = &plan.scenes;
  switch (level) {
    case Level::queries:
      for (const Hazard& hazard : hazards()) all.push_back(hazard.name);
      chosen = &plan.strata;
      break;
    case Level::responses: {
      static const std::vector<std::string> everything;
      all = response_parts();
      chosen = &everything;
      break;
    }
    case Level::runs:
      all = run_scenes();
      break;
    case Level::model:
      all = model_scenes();
      break;
    case Level::cases:
      for (const HardCase& one : hard_cases()) {
        if (plan.long_cases || !one.is_long || !plan.cases.empty()) all.push_back(one.name);
      }
      chosen = &plan.cases;
      break;
  }
  std::erase_if(all, [&](const std::string& name) { return !is_wanted(*chosen, name); });
  return all;
}

/// Whether a study has a part.
bool has(const Json& study, Level level, const std::string& part) {
  const auto any = [](const Json& list, auto&& is_it) {
    return std::any_of(list.begin(), list.end(), is_it);
  };
  const auto named = [&](const char* key) {
    return [&part, key](const Json& one) { return one.at(key) == part; };
  };
  const Json& of_level = study.at(key_of(level));
  switch (level) {
    case Level::queries:
    case Level::cases:
      return any(of_level, named("name"));
    case Level::responses:
      return any(of_level.at("rows"), [&](const Json& row) {
        return row.at("op").get<std::string>() + ", " + row.at("stratum").get<std::string>() == part;
      });
    case Level::runs:
      return any(of_level.at("rows"), named("scene"));
    case Level::model:
      return any(of_level.at("truths"), named("scene")) ||
             (part == "revolution" && !of_level.at("revolution").empty());
  }
  return false;
}

Json measured_queries(const StudyPlan& plan, const std::string& name) {
  const auto& all = hazards();
  const Hazard& hazard =
      *std::find_if(all.begin(), all.end(), [&](const Hazard& one) { return one.name == name; });
  StratumResult result = measure_accuracy(hazard, plan.questions, plan.variants);
  if (plan.with_times) measure_times(result, plan.questions, plan.variants);
  return Json::array({stratum_json(result)});
}

Json measured_case(const std::string& name) {
  const std::vector<HardCase> all = hard_cases();
  return cases_json({measure_case(
      *std::find_if(all.begin(), all.end(), [&](const HardCase& one) { return one.name == name; }))});
}

/// One part as a study that has no other.
Json measured(const StudyPlan& plan, Level level, const std::string& part, const Announce& announce) {
  switch (level) {
    case Level::queries:
      return measured_queries(plan, part);
    case Level::responses:
      return responses_json(measure_responses({plan.questions.seed,
                                               plan.response_questions,
                                               plan.response_repetitions,
                                               {part},
                                               [](const std::string&) {}}));
    case Level::runs:
      return runs_json(
          measure_runs({plan.questions.seed, plan.events, plan.proves_stored, {part}, announce}));
    case Level::model:
      return model_json(measure_model({plan.questions.seed, {part}, announce}));
    case Level::cases:
      return measured_case(part);
  }
  return {};
}

/// Appends the elements of every list of a part.
void extend(Json& level, const Json& part) {
  if (level.is_array()) {
    level.insert(level.end(), part.begin(), part.end());
    return;
  }
  for (const auto& [key, value] : part.items()) {
    if (value.is_array()) level[key].insert(level[key].end(), value.begin(), value.end());
  }
}

/// A level without a part.
Json empty_level(const StudyPlan& plan, Level level) {
  switch (level) {
    case Level::responses: {
      ResponseLevel none;
      none.seed = plan.questions.seed;
      none.questions = plan.response_questions;
      return responses_json(none);
    }
    case Level::runs: {
      RunLevel none;
      none.seed = plan.questions.seed;
      none.events = plan.events;
      return runs_json(none);
    }
    case Level::model: {
      ModelLevel none;
      none.seed = plan.questions.seed;
      return model_json(none);
    }
    default:
      return Json::array();
  }
}

}  // namespace

StudyPlan quick_plan() {
  StudyPlan plan;
  plan.response_questions = 20;
  plan.response_repetitions = 3;
  plan.events = 800;
  plan.proves_stored = false;
  plan.long_cases = false;
  return plan;
}

StudyPlan full_plan() {
  StudyPlan plan;
  plan.questions = {1, 50'000, 1024, 31};
  return plan;
}

std::vector<std::string> study_scenes() {
  std::vector<std::string> names = run_scenes();
  for (const std::string& name : model_scenes()) {
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return names;
}

Json planned(const StudyPlan& plan, const Machine& machine) {
  const bool asks = std::find(plan.levels.begin(), plan.levels.end(), Level::queries) != plan.levels.end();
  Json study = asks ? study_json(plan.questions, plan.variants, machine)
                    : Json{{"cost", 1}, {"machine", machine_json(machine)}};
  for (const Level level : plan.levels) study[key_of(level)] = empty_level(plan, level);
  return study;
}

std::string difference_of_plans(const Json& stored, const Json& fresh) {
  for (const auto& [key, value] : fresh.items()) {
    if (!stored.contains(key)) continue;
    if (key == "machine" || key == "settings" || key == "formulas" || key == "variants") {
      if (stored.at(key) != value) return "/" + key;
    }
    if (!value.is_object() || key == "settings" || key == "machine") continue;
    for (const auto& [setting, number] : value.items()) {
      if (number.is_number() && stored.at(key).at(setting) != number) return "/" + key + "/" + setting;
    }
  }
  return {};
}

void adopt_levels(Json& study, const Json& fresh) {
  for (const auto& [key, value] : fresh.items()) {
    if (!study.contains(key)) study[key] = value;
  }
}

void measure_study(const StudyPlan& plan, Json& study, const Announce& announce,
                   const std::function<void(const Json&)>& save) {
  for (const Level level : plan.levels) {
    const std::vector<std::string> parts = parts_of(level, plan);
    for (std::size_t k = 0; k < parts.size(); ++k) {
      if (has(study, level, parts[k])) continue;
      announce(key_of(level) + ": " + parts[k] + " (" + std::to_string(k + 1) + " of " +
               std::to_string(parts.size()) + ")");
      extend(study[key_of(level)], measured(plan, level, parts[k], announce));
      save(study);
      interrupt::check();
    }
  }
}

}  // namespace tps::cost
