// The levels above single questions: responses, whole runs, the model's own numbers, hard cases by
// name. Each is a part
// of the study's JSON, and every report is made of that.
#pragma once

#include <string>

#include "verify/cost/hard_cases.hpp"
#include "verify/cost/machine.hpp"
#include "verify/cost/model_level.hpp"
#include "verify/cost/report.hpp"
#include "verify/cost/response_level.hpp"
#include "verify/cost/run_level.hpp"

namespace tps::cost {

/// A study of one level: data/schemas/cost.schema.json.
Json runs_json(const RunLevel& level, const Machine& machine);
Json model_json(const ModelLevel& level, const Machine& machine);
Json responses_json(const ResponseLevel& level, const Machine& machine);
Json cases_json(const std::vector<CaseResult>& cases, const Machine& machine);

/// What is good enough for a case of such a study: "double stable", "none", or "ties" where to agree is luck.
std::string verdict_of(const Json& one);

/// The levels that a study has, as tables; empty where it has none.
std::string levels_text(const Json& study);
/// A row for each run, with a line of names.
std::string levels_csv(const Json& study);
/// Sections of the page.
std::string levels_page(const Json& study);

}  // namespace tps::cost
