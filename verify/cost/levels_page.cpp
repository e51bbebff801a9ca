// The sections of the page for whole runs, the model's numbers and the hard cases.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "reference/text/plain_json.hpp"
#include "reference/text/printable.hpp"
#include "verify/cost/json_at.hpp"
#include "verify/cost/levels.hpp"
#include "verify/cost/named_lines.hpp"

namespace tps::cost {
namespace {

constexpr const char* kResponsesText =
    R"(<h2 id="responses">Responses: eqs. (4), (5) and (7)</h2>
<p>Against certified enclosures between doubles. <i>Off</i>: a component, as a double, lies outside of its enclosure. Errors are told for float and double.</p>
)";
constexpr const char* kRunsText =
    R"(<h2 id="runs">Whole runs: the horizon</h2>
<p>How many events, in order, are those of the run in 100 digits. What has all of them has no mark. <i>Proven</i>: events that are certain
in affine arithmetic of so many bits; for every start within the rounding of the scene's numbers, at the 53 bits of these.</p>
)";
constexpr const char* kGroupingText =
    R"(<h2 id="grouping">What the time of restitution buys and costs</h2>
<p>The same scene grouped with each Δt_restitute, against its ungrouped truth.</p>
)";
constexpr const char* kRevolutionText =
    R"(<h2 id="revolution">What the angle of revolution buys and costs</h2>
<p>A pair that circles on a taut tether: events for a turn, and what of energy and angular momentum a turn and the first event take.</p>
)";
constexpr const char* kCasesText =
    R"(<h2 id="cases">Hard cases</h2>
<p>Events, in order, that are those of the run in 100 digits; the end where it is another one; the fewest bits in which affine arithmetic proves
every event; and the first arithmetic that has all.</p>
)";

constexpr double kDoubleBits = 53;

/// log10, and a little below the axis for nothing at all.
double log10_of(double x, double nothing) {
  return x > 0 ? std::max(std::log10(x), nothing) : nothing;
}

double largest(const Json& rows, const char* key) {
  double most = 1;
  for (const Json& row : rows) {
    if (row.contains(key)) most = std::max(most, number_at(row, key));
  }
  return most;
}

/// A whole number of units that about five ticks of an axis to `most` are apart.
int tick_distance(double most) {
  const double unit = std::pow(10.0, std::floor(std::log10(most / 2)));
  return std::max(1, static_cast<int>(unit * (most / unit > 10 ? 5 : most / unit > 5 ? 2 : 1)));
}

/// As many as were asked for, or as there are.
bool has_all(const Json& proven) {
  const std::string why = text_at(proven, "ends_by");
  return why == "events" || why == "end";
}

std::string proven_list(const Json& proven) {
  std::string text = "<ul>\n";
  for (const Json& row : proven) {
    text += fmt::format("<li>{}: {} events are proven for {}, in {} bits; {}{}</li>\n",
                        xml_text(text_at(row, "scene")), json_text(row.at("events")), starts_text(row),
                        json_text(row.at("bits")), ends_text(row),
                        row.contains("parts_at") ? "; the run in 100 digits has others" : "");
  }
  return text + "</ul>\n";
}

std::string horizon_tip(const Json& row) {
  return fmt::format("{} collisions or events of {}", json_text(row.at("horizon")),
                     json_text(row.at("events")));
}

std::string responses_page(const Json& responses) {
  Names names;
  Lines times(names, "time against bits, stratum plain", {"bits of the scalar", 0, 350, 0, 50},
              {"ns a response", 0, 6, 10, 1});
  Lines errors(names, "error in double, by stratum", {"stratum, in the order of the table", 0, 13, 0, 1},
               {"relative error, p99", -55, 1, 2, 5});
  errors.without_lines();
  std::string table =
      "<div "
      "class=\"scroll\"><table>\n<tr><th>operation</th><th>stratum</th><th>scalar</th><th>ns</th><th>asked</"
      "th>"
      "<th>other kind</th><th>lost</th><th>off</th><th>log2 error p50</th><th>p99</th><th>max "
      "seen</th></tr>\n";
  std::map<std::string, int> strata;
  for (const Json& row : responses.at("rows")) {
    const std::string op = text_at(row, "op"), stratum = text_at(row, "stratum"),
                      scalar = text_at(row, "scalar");
    const double ns = number_at(row, "ns");
    if (stratum == "plain") {
      times.add(op, {number_at(row, "bits"), log10_of(ns, 0)}, fmt::format("{}, {:.4g} ns", scalar, ns));
    }
    if (scalar == "double" && row.contains("log2_p99")) {
      const int place = strata.try_emplace(stratum, static_cast<int>(strata.size())).first->second;
      errors.add(op, {place + 0.5, number_at(row, "log2_p99")},
                 fmt::format("{}, 2^{:.1f} at p99", stratum, number_at(row, "log2_p99")));
    }
    table += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td>", xml_text(op), xml_text(stratum),
                         xml_text(scalar));
    for (const char* key : {"ns", "asked", "other_kind", "lost", "off", "log2_p50", "log2_p99", "log2_max"}) {
      table += fmt::format("<td>{}</td>", row.contains(key) ? json_text(row.at(key)) : "–");
    }
    table += "</tr>\n";
  }
  return kResponsesText + figures({times, errors}) + table + "</table></div>\n";
}

std::string runs_page(const Json& runs) {
  Names names;
  const Json& rows = runs.at("rows");
  const double most = std::max(largest(rows, "horizon"), largest(runs.at("proven"), "events"));
  Lines horizons(names, "horizon against bits", {"bits of the scalar", 0, 350, 0, 50},
                 {"events", 0, 1.05 * most, 0, tick_distance(most)});
  Lines speeds(names, "speed against bits", {"bits of the scalar", 0, 350, 0, 50},
               {"events a second", 0, 7, 10, 1});
  for (const Json& row : rows) {
    const std::string name = text_at(row, "scene") + ", " + text_at(row, "timing");
    const double bits = number_at(row, "bits");
    if (row.contains("horizon")) {
      horizons.add(name, {bits, number_at(row, "horizon")}, text_at(row, "scalar") + ", " + horizon_tip(row));
    }
    const double rate = number_at(row, "events_per_second");
    speeds.add(name, {bits, log10_of(rate, 0)},
               fmt::format("{}, {:.4g} events a second", text_at(row, "scalar"), rate));
  }
  for (const Json& row : runs.at("proven")) {
    if (has_all(row)) continue;
    const bool every_start = row.at("starts") == "rounding";
    horizons.add(text_at(row, "scene") + (every_start ? ", proven for every start" : ", proven"),
                 {every_start ? kDoubleBits : number_at(row, "bits"), number_at(row, "events")},
                 fmt::format("{} events, {}", json_text(row.at("events")), ends_text(row)));
  }
  std::string text = kRunsText + figures({horizons, speeds}) + proven_list(runs.at("proven"));
  for (const Json& fit : runs.at("fits")) {
    text += fmt::format(
        "<p>{}: {:.4g} ± {:.2g} events a bit; a disturbance grows by exp({:.4g} ± {:.2g}) an event.</p>\n",
        xml_text(text_at(fit, "scene")), number_at(fit, "events_per_bit"), number_at(fit, "standard_error"),
        number_at(fit, "exponent"), number_at(fit, "exponent_error"));
  }
  return text;
}

std::string grouping_page(const Json& model) {
  Names names;
  const Axis dt{"dt_restitute", -41, 0, 10, 5};
  const Json& rows = model.at("grouping");
  const double most = largest(rows, "horizon");
  Lines counts(names, "collisions", dt, {"collisions", 0, 6, 10, 1});
  Lines distances(names, "distance from the truth at the end", dt,
                  {"largest difference of a velocity", -18, 1, 10, 2});
  Lines horizons(names, "collisions that are those of the ungrouped run", dt,
                 {"collisions", 0, most, 0, tick_distance(most)});
  Lines groups(names, "the largest group", dt, {"particles", 0, 2, 10, 1});
  for (const Json& row : rows) {
    const std::string scene = text_at(row, "scene");
    const double x = log10_of(number_at(row, "dt_restitute"), -41);
    const std::string at = fmt::format("dt_restitute {:g}", number_at(row, "dt_restitute"));
    counts.add(
        scene, {x, log10_of(number_at(row, "collisions"), 0)},
        fmt::format("{}, {} collisions, end: {}", at, json_text(row.at("collisions")), text_at(row, "end")));
    groups.add(scene, {x, log10_of(number_at(row, "largest_group"), 0)},
               fmt::format("{}, {} particles", at, json_text(row.at("largest_group"))));
    if (row.contains("distance")) {
      distances.add(scene, {x, log10_of(number_at(row, "distance"), -18)},
                    fmt::format("{}, {:.3g}", at, number_at(row, "distance")));
    }
    if (row.contains("horizon")) {
      horizons.add(scene, {x, number_at(row, "horizon")},
                   fmt::format("{}, the first {} collisions", at, json_text(row.at("horizon"))));
    }
  }
  std::string text = kGroupingText + std::string("<ul>\n");
  for (const Json& truth : model.at("truths")) {
    text += fmt::format("<li><b>{}</b>: {}. Ungrouped: {} collisions, end: {}</li>\n",
                        xml_text(text_at(truth, "scene")), xml_text(text_at(truth, "what")),
                        json_text(truth.at("collisions")), xml_text(text_at(truth, "end")));
  }
  return text + "</ul>\n" + figures({counts, distances, horizons, groups});
}

std::string revolution_page(const Json& model) {
  Names names;
  const Axis theta{"theta, degrees", -6, 2, 10, 1};
  Lines events(names, "events a turn", theta, {"events", 0, 9, 10, 1});
  Lines losses(names, "what is lost", theta, {"share lost", -16, 0, 10, 2});
  for (const Json& row : model.at("revolution")) {
    const double x = log10_of(number_at(row, "theta_deg"), -6);
    const std::string c = fmt::format("c_revolve {:g}", number_at(row, "c_revolve"));
    const std::string at = fmt::format("theta {}", json_text(row.at("theta_deg")));
    events.add(c, {x, log10_of(number_at(row, "events_a_turn"), 0)},
               fmt::format("{}, {:.6g} events", at, number_at(row, "events_a_turn")));
    losses.add("angular momentum at the first, " + c, {x, log10_of(number_at(row, "momentum_at_first"), -16)},
               fmt::format("{}, {:.3g}", at, number_at(row, "momentum_at_first")));
    losses.add("energy a turn, " + c, {x, log10_of(number_at(row, "energy_a_turn"), -16)},
               fmt::format("{}, {:.3g}", at, number_at(row, "energy_a_turn")));
  }
  return kRevolutionText + figures({events, losses});
}

std::string cases_page(const Json& cases) {
  std::string text =
      kCasesText + std::string("<div class=\"scroll\"><table>\n<tr><th>case</th><th>events</th>");
  if (!cases.empty()) {
    for (const Json& outcome : cases.front().at("outcomes")) {
      text += fmt::format("<th>{}, {}</th>", xml_text(text_at(outcome, "scalar")),
                          xml_text(text_at(outcome, "timing")));
    }
  }
  text += "<th>bits that prove it</th><th>good enough</th></tr>\n";
  for (const Json& one : cases) {
    text += fmt::format("<tr><td><b>{}</b>: {}</td><td>{}</td>", xml_text(text_at(one, "name")),
                        xml_text(text_at(one, "what")), json_text(one.at("events")));
    for (const Json& outcome : one.at("outcomes"))
      text += fmt::format("<td>{}</td>", xml_text(outcome_text(one, outcome)));
    text += fmt::format("<td>{}</td><td>{}</td></tr>\n",
                        one.contains("proven_bits") ? json_text(one.at("proven_bits"))
                                                    : "– (" + xml_text(text_at(one, "unproven")) + ")",
                        xml_text(verdict_of(one)));
  }
  return text + "</table></div>\n";
}

}  // namespace

std::string levels_page(const Json& study) {
  std::string text;
  if (study.contains("responses")) text += responses_page(study.at("responses"));
  if (study.contains("runs")) text += runs_page(study.at("runs"));
  if (study.contains("model")) text += grouping_page(study.at("model")) + revolution_page(study.at("model"));
  if (study.contains("cases")) text += cases_page(study.at("cases"));
  return text;
}

}  // namespace tps::cost
