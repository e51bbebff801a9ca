#include <fmt/format.h>

#include "reference/text/plain_json.hpp"
#include "reference/text/printable.hpp"
#include "verify/cost/json_at.hpp"
#include "verify/cost/levels.hpp"

namespace tps::cost {
namespace {

/// A stored study may hold anything: what is printed is safe on a terminal.
std::string shown_at(const Json& value, const char* key) {
  return printable(text_at(value, key));
}

std::string horizon_text(const Json& row) {
  return row.contains("horizon") ? json_text(row.at("horizon")) : "all";
}

std::string parts_text(const Json& row) {
  return row.contains("parts_at")
             ? fmt::format("; from event {} on the run in mp100 has others", json_text(row.at("parts_at")))
             : "";
}

std::string runs_text(const Json& runs) {
  std::string text = fmt::format("{:<12}{:<13}{:<11}{:>7}{:>11}{:>10}{:>14}{:>14}\n", "scene", "scalar",
                                 "timing", "events", "events/s", "horizon", "momentum off", "energy off");
  for (const Json& row : runs.at("rows")) {
    text += fmt::format("{:<12}{:<13}{:<11}{:>7}{:>11.3g}{:>10}{:>14.1e}{:>14.1e}\n", shown_at(row, "scene"),
                        shown_at(row, "scalar"), shown_at(row, "timing"), json_text(row.at("events")),
                        number_at(row, "events_per_second"), horizon_text(row),
                        number_at(row, "momentum_drift"), number_at(row, "energy_remainder"));
  }
  for (const Json& row : runs.at("proven")) {
    text += fmt::format("{}: {} events are proven for {}, in {} bits; {}{}\n", shown_at(row, "scene"),
                        json_text(row.at("events")), starts_text(row), json_text(row.at("bits")),
                        ends_text(row), parts_text(row));
  }
  for (const Json& fit : runs.at("fits")) {
    text += fmt::format(
        "{}: {:.2f} +- {:.2f} events a bit ({} scalars): disturbances grow by exp({:.4f} +- {:.4f}) an "
        "event\n",
        shown_at(fit, "scene"), number_at(fit, "events_per_bit"), number_at(fit, "standard_error"),
        json_text(fit.at("points")), number_at(fit, "exponent"), number_at(fit, "exponent_error"));
  }
  return text;
}

std::string grouping_text(const Json& model, const Json& truth) {
  std::string text = fmt::format("{}: {}\n  {:>12}{:>11}{:>9}{:>9}{:>9}{:>11}{:>10}  {}\n",
                                 shown_at(truth, "scene"), shown_at(truth, "what"), "dt_restitute",
                                 "collisions", "events", "largest", "horizon", "distance", "kinetic", "end");
  text += fmt::format("  {:>12}{:>11}{:>9}{:>9}{:>9}{:>11}{:>10.4g}  {}\n", "ungrouped",
                      json_text(truth.at("collisions")), json_text(truth.at("collisions")), "-", "-", "-",
                      number_at(truth, "kinetic"), shown_at(truth, "end"));
  for (const Json& row : model.at("grouping")) {
    if (row.at("scene") != truth.at("scene")) continue;
    text += fmt::format("  {:>12g}{:>11}{:>9}{:>9}{:>9}{:>11}{:>10.4g}  {}\n", number_at(row, "dt_restitute"),
                        json_text(row.at("collisions")), json_text(row.at("events")),
                        json_text(row.at("largest_group")),
                        truth.at("end") == "stalled" ? "-" : horizon_text(row),
                        row.contains("distance") ? fmt::format("{:.1e}", number_at(row, "distance")) : "-",
                        number_at(row, "kinetic"), shown_at(row, "end"));
  }
  return text + "\n";
}

std::string model_text(const Json& model) {
  std::string text;
  for (const Json& truth : model.at("truths")) text += grouping_text(model, truth);
  text += fmt::format(
      "revolution: a pair that circles; shares of energy and angular momentum that are lost\n"
      "  {:>12}{:>11}{:>15}{:>15}{:>17}{:>20}\n",
      "theta", "c_revolve", "events a turn", "energy a turn", "momentum a turn", "momentum at first");
  for (const Json& row : model.at("revolution")) {
    text += fmt::format("  {:>12}{:>11g}{:>15.6g}{:>15.2e}{:>17.2e}{:>20.2e}\n",
                        json_text(row.at("theta_deg")), number_at(row, "c_revolve"),
                        number_at(row, "events_a_turn"), number_at(row, "energy_a_turn"),
                        number_at(row, "momentum_a_turn"), number_at(row, "momentum_at_first"));
  }
  return text;
}

std::string cases_text(const Json& cases) {
  if (cases.empty()) return "";
  std::string text = fmt::format("{:<17}{:>7}", "case", "events");
  const char* const names[] = {"float", "printed", "stable", "certified", "long double", "quad", "mp50"};
  for (const char* name : names) text += fmt::format("{:>13}", name);
  text += fmt::format("{:>9}  good enough\n", "proven");
  for (const Json& one : cases) {
    text += fmt::format("{:<17}{:>7}", shown_at(one, "name"), json_text(one.at("events")));
    for (const Json& outcome : one.at("outcomes")) text += fmt::format("{:>13}", outcome_text(one, outcome));
    text += fmt::format("{:>9}  {}\n", one.contains("proven_bits") ? json_text(one.at("proven_bits")) : "-",
                        printable(verdict_of(one)));
  }
  return text;
}

/// log2 of an error over the unit roundoff, where it is told.
std::string bits_lost(const Json& row, const char* key) {
  if (!row.contains(key)) return "-";
  const double lost = number_at(row, key) + number_at(row, "bits");
  return lost <= 0 ? "0" : fmt::format("{:.1f}", lost);
}

std::string responses_text(const Json& responses) {
  std::string text =
      fmt::format("{:<20}{:<15}{:<13}{:>9}{:>7}{:>7}{:>7}{:>7}{:>8}{:>8}{:>8}\n", "operation", "stratum",
                  "scalar", "ns", "asked", "kind", "lost", "off", "lost50", "lost99", "most");
  for (const Json& row : responses.at("rows")) {
    text += fmt::format("{:<20}{:<15}{:<13}{:>9.4g}{:>7}{:>7}{:>7}{:>7}{:>8}{:>8}{:>8}\n",
                        shown_at(row, "op"), shown_at(row, "stratum"), shown_at(row, "scalar"),
                        number_at(row, "ns"), json_text(row.at("asked")), json_text(row.at("other_kind")),
                        json_text(row.at("lost")), json_text(row.at("off")), bits_lost(row, "log2_p50"),
                        bits_lost(row, "log2_p99"), bits_lost(row, "log2_max"));
  }
  return text;
}

}  // namespace

std::string outcome_text(const Json& one, const Json& outcome) {
  if (!outcome.contains("horizon")) return "all";
  const std::string end = shown_at(outcome, "end");
  if (end == "refused") return end;
  const std::string agreed = json_text(outcome.at("horizon"));
  return outcome.at("end") == one.at("end") ? agreed
         : end == "stalled"                 ? agreed + " stalled"
                                            : agreed + " " + end;
}

std::vector<Json> level_rows(const Json& study) {
  std::vector<Json> rows;
  const auto append = [&](const Json& list, const Json& head) {
    for (const Json& row : list) {
      rows.push_back(head);
      rows.back().update(row);
    }
  };
  if (study.contains("responses")) append(study.at("responses").at("rows"), {{"level", "responses"}});
  if (study.contains("runs")) {
    append(study.at("runs").at("rows"), {{"level", "runs"}});
    append(study.at("runs").at("proven"), {{"level", "proven"}});
  }
  if (study.contains("model")) {
    append(study.at("model").at("grouping"), {{"level", "grouping"}});
    append(study.at("model").at("revolution"), {{"level", "revolution"}});
  }
  if (study.contains("cases")) {
    for (const Json& one : study.at("cases")) {
      Json head{{"level", "cases"}, {"scene", one.at("name")}};
      if (one.contains("proven_bits")) head["proven_bits"] = one.at("proven_bits");
      append(one.at("outcomes"), head);
    }
  }
  return rows;
}

std::string levels_text(const Json& study) {
  std::string text;
  const auto add = [&](const char* level, std::string (*as_text)(const Json&)) {
    if (!study.contains(level)) return;
    if (!text.empty()) text += "\n";
    text += as_text(study.at(level));
  };
  add("responses", responses_text);
  add("runs", runs_text);
  add("model", model_text);
  add("cases", cases_text);
  return text;
}

}  // namespace tps::cost
