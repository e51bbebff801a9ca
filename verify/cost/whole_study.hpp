// A study of any of the levels, part by part, so that one that was ended goes on where it was.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "verify/cost/levels.hpp"

namespace tps::cost {

enum class Level {
  queries,    ///< eq. (2); parts are strata
  responses,  ///< eqs. (4), (5), (7); parts are an equation on a stratum
  runs,       ///< parts are scenes
  model,      ///< parts are scenes
  cases       ///< parts are hard cases
};

/// What is measured, and how thoroughly.
struct StudyPlan {
  std::vector<Level> levels;
  StudyOptions questions;
  std::vector<Variant> variants;
  bool with_times = true;                          ///< of questions
  std::vector<std::string> strata, scenes, cases;  ///< only these; empty: all
  int response_questions = 200;
  int response_repetitions = 5;
  std::uint64_t events = 3000;  ///< of each of the runs, at most
  bool proves_stored = true;    ///< as in RunLevelOptions
  bool long_cases = true;       ///< also hard cases that take long; those that are named in any case
};

/// Much less of everything, for a look: a minute in all.
StudyPlan quick_plan();
/// Rates of ten in a million show, and intervals are narrow: a quarter of an hour.
StudyPlan full_plan();

/// Names that `scenes` can hold.
std::vector<std::string> study_scenes();

/// The study with its settings, and no part yet. data/schemas/cost.schema.json describes it.
Json planned(const StudyPlan& plan, const Machine& machine);

/// What of `stored` is of another study than `fresh`: a pointer into it; empty where it can go on. REQUIRES
/// two studies that keep to the schema.
std::string difference_of_plans(const Json& stored, const Json& fresh);

/// Adds to a study the levels that it has not, empty.
void adopt_levels(Json& study, const Json& fresh);

/// Measures every part of the plan that the study has not. `announce` is told before each what it is, `save`
/// behind each what there is.
void measure_study(const StudyPlan& plan, Json& study, const Announce& announce,
                   const std::function<void(const Json&)>& save);

}  // namespace tps::cost
