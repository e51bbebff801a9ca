#include "verify/cost/levels.hpp"
#include "verify/cost/rounded.hpp"

namespace tps::cost {
namespace {

Json row_json(const RunRow& row) {
  Json json{{"scene", row.scene},
            {"scalar", row.scalar},
            {"timing", row.timing},
            {"bits", row.bits},
            {"end", row.end},
            {"events", row.events},
            {"events_per_second", rounded(row.events_per_second)},
            {"momentum_drift", rounded(row.momentum_drift)},
            {"energy_remainder", rounded(row.energy_remainder)},
            {"worst_excess", rounded(row.worst_excess)}};
  if (row.horizon) json["horizon"] = *row.horizon;
  return json;
}

Json row_json(const ProvenRow& row) {
  Json json{{"scene", row.scene},
            {"starts", row.every_start ? "rounding" : "stored"},
            {"bits", row.bits},
            {"events", row.events},
            {"ends_by", row.ends_by}};
  if (row.parts_at) json["parts_at"] = *row.parts_at;
  return json;
}

Json row_json(const GroupingRow& row) {
  Json json{{"scene", row.scene},
            {"dt_restitute", row.dt_restitute},
            {"end", row.end},
            {"collisions", row.collisions},
            {"events", row.events},
            {"largest_group", row.largest_group},
            {"kinetic", rounded(row.kinetic)}};
  if (row.distance) json["distance"] = rounded(*row.distance);
  if (row.horizon) json["horizon"] = *row.horizon;
  return json;
}

Json row_json(const RevolutionRow& row) {
  return {{"theta_deg", row.theta_deg},
          {"c_revolve", row.c_revolve},
          {"events", row.events},
          {"events_a_turn", rounded(row.events_a_turn)},
          {"energy_a_turn", rounded(row.energy_a_turn)},
          {"momentum_a_turn", rounded(row.momentum_a_turn)},
          {"momentum_at_first", rounded(row.momentum_at_first)}};
}

Json row_json(const ResponseRow& row) {
  Json json{{"op", row.op},     {"stratum", row.stratum}, {"scalar", row.scalar},
            {"bits", row.bits}, {"asked", row.asked},     {"other_kind", row.other_kind},
            {"lost", row.lost}, {"off", row.off},         {"ns", rounded(row.ns)}};
  if (row.log2_max) {
    json["log2_p50"] = rounded(*row.log2_p50);
    json["log2_p99"] = rounded(*row.log2_p99);
    json["log2_max"] = rounded(*row.log2_max);
  }
  return json;
}

template <typename Row>
Json rows_json(const std::vector<Row>& rows) {
  Json json = Json::array();
  for (const Row& row : rows) json.push_back(row_json(row));
  return json;
}

Json case_json(const CaseResult& one) {
  Json outcomes = Json::array();
  for (const CaseOutcome& outcome : one.outcomes) {
    Json json{{"scalar", outcome.scalar},
              {"timing", outcome.timing},
              {"end", outcome.end},
              {"events", outcome.events},
              {"worst_excess", rounded(outcome.worst_excess)}};
    if (outcome.horizon) json["horizon"] = *outcome.horizon;
    outcomes.push_back(json);
  }
  Json json{{"name", one.name}, {"what", one.what}, {"events", one.events}, {"end", one.end}};
  if (one.right_by == RightBy::nothing) json["rests_on_ties"] = true;
  if (const CaseOutcome* good = one.good_enough()) json["good_enough"] = good->scalar + " " + good->timing;
  if (one.proven_bits) {
    json["proven_bits"] = *one.proven_bits;
  } else {
    json["unproven"] = one.unproven;
  }
  json["outcomes"] = outcomes;
  return json;
}

}  // namespace

Json runs_json(const RunLevel& level) {
  Json fits = Json::array();
  for (const HorizonFit& fit : level.fits) {
    fits.push_back({{"scene", fit.scene},
                    {"points", fit.points},
                    {"events_per_bit", rounded(fit.events_per_bit)},
                    {"standard_error", rounded(fit.standard_error)},
                    {"exponent", rounded(fit.exponent())},
                    {"exponent_error", rounded(fit.exponent_error())}});
  }
  return {{"seed", level.seed},
          {"events", level.events},
          {"rows", rows_json(level.rows)},
          {"proven", rows_json(level.proven)},
          {"fits", fits}};
}

Json model_json(const ModelLevel& level) {
  Json truths = Json::array();
  for (const GroupingTruth& truth : level.truths) {
    truths.push_back({{"scene", truth.scene},
                      {"what", truth.what},
                      {"end", truth.end},
                      {"collisions", truth.collisions},
                      {"kinetic", rounded(truth.kinetic)}});
  }
  return {{"seed", level.seed},
          {"truths", truths},
          {"grouping", rows_json(level.grouping)},
          {"revolution", rows_json(level.revolution)}};
}

Json responses_json(const ResponseLevel& level) {
  return {{"seed", level.seed}, {"questions", level.questions}, {"rows", rows_json(level.rows)}};
}

std::string verdict_of(const Json& one) {
  if (one.contains("rests_on_ties")) return "ties";
  return one.contains("good_enough") ? one.at("good_enough").get<std::string>() : "none";
}

std::string starts_text(const Json& row) {
  return row.at("starts") == "rounding" ? "every start that rounds to the stored one" : "the stored start";
}

std::string ends_text(const Json& row) {
  const std::string why = row.at("ends_by").get<std::string>();
  if (why == "events") return "as many as were asked for";
  if (why == "end") return "all there are";
  if (why == "start") return "a pair may begin at a limit";
  return why == "order" ? "then two may come in either order" : "then one may come or not";
}

Json cases_json(const std::vector<CaseResult>& cases) {
  Json json = Json::array();
  for (const CaseResult& one : cases) json.push_back(case_json(one));
  return json;
}

}  // namespace tps::cost
