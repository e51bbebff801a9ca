// The levels above single questions: responses, whole runs, the model's own numbers, hard cases by name. Each
// is a part of the study's JSON, and every report is made of that.
#pragma once

#include <string>

#include "verify/cost/hard_cases.hpp"
#include "verify/cost/model_level.hpp"
#include "verify/cost/report.hpp"
#include "verify/cost/response_level.hpp"
#include "verify/cost/run_level.hpp"

namespace tps::cost {

/// The part of a study that a level is, as data/schemas/cost.schema.json has it.
Json runs_json(const RunLevel& level);
Json model_json(const ModelLevel& level);
Json responses_json(const ResponseLevel& level);
Json cases_json(const std::vector<CaseResult>& cases);

/// What is good enough for a case of such a study: "double stable", "none", or "ties" where to agree is luck.
std::string verdict_of(const Json& one);

/// What stands in a table for an outcome: how far it agrees, and the end where that is another one.
std::string outcome_text(const Json& one, const Json& outcome);

/// Of a row of runs.proven: for which starts, and why there is no further event.
std::string starts_text(const Json& row);
std::string ends_text(const Json& row);

/// The levels that a study has, as tables; empty where it has none.
std::string levels_text(const Json& study);
/// Every row of the levels as an object, with the level that it is of.
std::vector<Json> level_rows(const Json& study);
/// Sections of the page.
std::string levels_page(const Json& study);

}  // namespace tps::cost
