// The study as JSON, and what is made of that: CSV, a text, a page. A report is made from the JSON alone, so
// that a stored study can be shown again (`tps cost --from`). Levels above single questions: levels.hpp.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "verify/cost/machine.hpp"
#include "verify/cost/study.hpp"
#include "verify/cost/variant.hpp"

namespace tps::cost {

using Json = nlohmann::ordered_json;

/// Settings, machine, formulas, the variants measured; no stratum yet. data/schemas/cost.schema.json
/// describes it.
Json study_json(const StudyOptions& options, const std::vector<Variant>& measured, const Machine& machine);
Json machine_json(const Machine& machine);
/// One element of "strata".
Json stratum_json(const StratumResult& result);

/// The study as a file: a line for each cell and bin.
std::string study_text(const Json& study);

/// A stored study. Throws InputError where it keeps not to the schema, or names what it does not list.
Json read_study(const std::string& path);

/// A row for each variant and stratum, with a line of names.
std::string report_csv(const Json& study);
/// A table for each stratum.
std::string report_text(const Json& study);
/// One page that needs nothing else: plots that Vega draws, every number as text too.
std::string report_page(const Json& study);

}  // namespace tps::cost
