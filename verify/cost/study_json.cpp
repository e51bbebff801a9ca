#include "reference/text/plain_json.hpp"
#include "verify/cost/report.hpp"
#include "verify/cost/rounded.hpp"
#include "verify/cost/variant.hpp"

namespace tps::cost {
namespace {

constexpr double kConfidence = 0.95;

Json per_million(std::uint64_t count, std::uint64_t asked) {
  const Interval interval = proportion_interval(count, asked, kConfidence);
  return {{"value", rounded(1e6 * static_cast<double>(count) / static_cast<double>(asked))},
          {"low", rounded(1e6 * interval.low)},
          {"high", rounded(1e6 * interval.high)}};
}

void add_verdicts(Json& to, const WrongVerdicts& verdicts) {
  to["asked"] = verdicts.asked;
  to["missed"] = verdicts.missed;
  to["invented"] = verdicts.invented;
  to["moved"] = verdicts.moved;
}

Json errors_json(const Errors& errors) {
  Json json{{"compared", errors.compared}};
  if (errors.compared == 0) return json;
  json["p50"] = rounded(errors.p50);
  json["p99"] = rounded(errors.p99);
  json["max"] = rounded(errors.max);
  return json;
}

Json quantiles_json(const Quantiles& q) {
  return {{"min", rounded(q.min)},
          {"q1", rounded(q.q1)},
          {"median", rounded(q.median)},
          {"q3", rounded(q.q3)},
          {"max", rounded(q.max)}};
}

Json cell_json(const Cell& cell) {
  Json json{{"variant", cell.variant}};
  add_verdicts(json, cell.verdicts);
  json["wrong_per_million"] = per_million(cell.verdicts.all(), cell.verdicts.asked);
  json["log2_error"] = errors_json(cell.errors);
  if (cell.times) {
    json["ns"] = {{"throughput", quantiles_json(cell.times->throughput)},
                  {"latency", quantiles_json(cell.times->latency)}};
    json["ratio"] = {{"value", rounded(cell.times->ratio)},
                     {"low", rounded(cell.times->ratio_interval.low)},
                     {"high", rounded(cell.times->ratio_interval.high)}};
  }
  for (const Path& path : cell.paths) {
    json["paths"].push_back({{"name", path.name}, {"questions", path.questions}, {"ns", rounded(path.ns)}});
  }
  return json;
}

Json tangency_json(const std::vector<Bin>& bins) {
  Json json = Json::array();
  for (const Bin& bin : bins) {
    Json point{{"variant", bin.variant}, {"log2_distance", bin.exponent}};
    add_verdicts(point, bin.verdicts);
    json.push_back(point);
  }
  return json;
}

Json condition_json(const std::vector<Bin>& bins) {
  Json json = Json::array();
  for (const Bin& bin : bins) {
    if (bin.errors.compared == 0) continue;
    json.push_back({{"variant", bin.variant},
                    {"log2_condition", bin.exponent},
                    {"compared", bin.errors.compared},
                    {"log2_error_max", rounded(bin.errors.max)}});
  }
  return json;
}

constexpr int kDeepestLines = 4;  ///< study, strata, stratum, cells; a cell is a line

void write(const Json& value, int depth, std::string& text) {
  if (depth >= kDeepestLines || !value.is_structured() || value.empty()) {
    text += json_text(value);
    return;
  }
  text += value.is_array() ? "[" : "{";
  const char* before = "\n";
  for (const auto& [key, element] : value.items()) {
    text += before + std::string(static_cast<std::size_t>(depth) + 1, ' ');
    if (value.is_object()) text += json_text(Json(key)) + ": ";
    write(element, depth + 1, text);
    before = ",\n";
  }
  text += "\n" + std::string(static_cast<std::size_t>(depth), ' ') + (value.is_array() ? "]" : "}");
}

}  // namespace

std::string study_text(const Json& study) {
  std::string text;
  write(study, 0, text);
  return text + "\n";
}

Json machine_json(const Machine& machine) {
  return {{"processor", machine.processor},
          {"compiler", machine.compiler},
          {"flags", machine.flags},
          {"version", machine.version}};
}

Json study_json(const StudyOptions& options, const std::vector<Variant>& measured, const Machine& machine) {
  Json json{{"cost", 1},
            {"settings",
             {{"seed", options.seed},
              {"questions", options.questions},
              {"timed", options.timed},
              {"repetitions", options.repetitions},
              {"confidence", kConfidence},
              {"baseline", kBaseline}}},
            {"machine", machine_json(machine)},
            {"formulas", Json::array()},
            {"variants", Json::array()},
            {"strata", Json::array()}};
  for (const Formula& formula : formulas()) {
    json["formulas"].push_back({{"name", formula.name}, {"what", formula.what}});
  }
  for (const Variant& variant : measured) {
    if (!variant.what.empty())
      json["formulas"].push_back({{"name", variant.formula}, {"what", variant.what}});
    json["variants"].push_back({{"name", variant.name},
                                {"formula", variant.formula},
                                {"arithmetic", variant.arithmetic},
                                {"bits", variant.bits},
                                {"has_time", variant.has_time}});
  }
  return json;
}

Json stratum_json(const StratumResult& result) {
  Json cells = Json::array();
  for (const Cell& cell : result.cells) cells.push_back(cell_json(cell));
  return {{"name", result.stratum},
          {"what", result.what},
          {"cells", cells},
          {"by_tangency", tangency_json(result.by_tangency)},
          {"by_condition", condition_json(result.by_condition)}};
}

}  // namespace tps::cost
