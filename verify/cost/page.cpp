#include <fmt/format.h>

#include "reference/text/plain_json.hpp"
#include "reference/text/printable.hpp"
#include "verify/cost/levels.hpp"
#include "verify/cost/page_figures.hpp"
#include "verify/cost/plot_script.hpp"
#include "verify/cost/report.hpp"
#include "verify/view/safe_page.hpp"

namespace tps::cost {
namespace {

/// Colours by formula that differ in lightness, too; the arithmetic stands beside each point.
constexpr const char* kColours[][2] = {  // on light, on dark
    {"#b3261e", "#ff8a80"}, {"#c26a00", "#ffb74d"}, {"#8a6d00", "#e6cf5c"}, {"#3f7d20", "#9ccc65"},
    {"#00796b", "#4dd0c4"}, {"#5d4037", "#bcaaa4"}, {"#616161", "#bdbdbd"}, {"#1565c0", "#64b5f6"},
    {"#4527a0", "#b39ddb"}, {"#000000", "#ffffff"}, {"#ad1457", "#f48fb1"}, {"#0277bd", "#81d4fa"}};

constexpr const char* kStyle = R"(
:root{color-scheme:light dark;--paper:#fff;--ink:#1b1b1b;--faint:#d9d9d9;--soft:#5c5c5c}
@media (prefers-color-scheme:dark){:root{--paper:#15171a;--ink:#ececec;--faint:#3a3d42;--soft:#a8a8a8}}
body{background:var(--paper);color:var(--ink);font:16px/1.5 system-ui,sans-serif;max-width:1480px;margin:auto;padding:1rem}
.figures{display:grid;grid-template-columns:repeat(auto-fill,minmax(440px,1fr));gap:1rem}
nav a,a:visited{color:inherit;margin-right:.8em}figure{margin:0;position:relative}figcaption{font-size:13px;font-weight:600;margin-left:3.6em;min-height:2.6em}
.plot svg{display:block;width:100%;height:auto;overflow:visible}.reach path{outline:none}.reach path:focus,.reach path:hover{stroke:var(--ink)}
.tip{position:absolute;top:3.1em;left:4.6em;right:0;margin:0;font-size:12px;line-height:1.2;visibility:hidden}.tip.shown{visibility:visible}
table{border-collapse:collapse;font-size:13px}td,th{padding:.1rem .6rem;text-align:right;border-bottom:1px solid var(--faint)}
td:first-child,th:first-child{text-align:left}td:first-child{min-width:12em}.scroll{overflow-x:auto}.lines{font-size:12px;margin:0 0 0 4.2em}.key{display:inline-block;width:.8em;height:.8em;border-radius:50%}
@media print{.tip{display:none}body{max-width:none;font-size:10pt}.figures{grid-template-columns:1fr 1fr}figure,tr{break-inside:avoid}}
)";

const Selection kFormulas{"formulas, in double", "", "double"};
const Selection kPrinted{"eq. (2) as printed, in each arithmetic", "printed", ""};
const Selection kStable{"the reference's formula, in each arithmetic", "stable", ""};

constexpr const char* kHowToRead =
    R"(<p>Point at a mark for its figures, or go to a plot by the tabulator key and from mark to mark by the arrow keys. Numbers beside marks are the bits (or decimal
digits: d of Boost, m of MPFR) of the arithmetic; c stands for certified answers. What the figures mean: docs/accuracy-cost.md.</p>
<noscript><p><b>Plots need scripts</b>, which are off here. The list in each place has its numbers.</p></noscript>
)";
constexpr const char* kWithoutVega =
    R"(<p><b>There are no figures:</b> this tps was built without Vega (Debian: libjs-vega). Install it, configure again, build, and make
this page anew from the stored study (tps cost --from STUDY.json --page PAGE.html). The list in each place has its numbers.</p>
)";
constexpr const char* kParetoText =
    R"(<h2 id="queries">Single questions: time against error</h2>
<p>A cross has wrong verdicts. The solid front is of variants without, the dashed one of all. Marks at the lower edge lie below it.</p>
)";
constexpr const char* kTangencyText =
    R"(<h2>Wrong verdicts against distance from tangency</h2>
<p>Stratum graze. A pair whose path passes the centre at ρ touches the limit L where ρ = L.</p>
)";
constexpr const char* kConditionText =
    R"(<h2>Error against condition number</h2>
<p>Over all strata but any_scale, units, wide and subnormal, whose hazard is the range of numbers. Broken lines: the unit roundoff times the
condition number. Float also rounds the question, which the condition number does not count.</p>
)";

std::string safe_text(const Json& value, const char* key) {
  return xml_text(value.at(key).get<std::string>());
}

std::string colours() {
  std::string light, dark, keys;
  for (std::size_t k = 0; k < std::size(kColours); ++k) {
    light += fmt::format("--series-{}:{};", k, kColours[k][0]);
    dark += fmt::format("--series-{}:{};", k, kColours[k][1]);
    keys += fmt::format(".series-{0}.key{{background:var(--series-{0})}}", k);
  }
  return ":root{" + light + "}@media (prefers-color-scheme:dark){:root{" + dark + "}}" + keys;
}

std::string legend(const Json& study) {
  std::string text = "<ul class=\"legend\">\n";
  std::size_t k = 0;
  for (const Json& formula : study.at("formulas")) {
    text += fmt::format("<li><span class=\"key series-{}\"></span> <b>{}</b>: {}</li>\n", k++,
                        safe_text(formula, "name"), safe_text(formula, "what"));
  }
  return text + "</ul>\n";
}

std::string number(const Json& cell, const char* pointer, const char* form) {
  const Json::json_pointer place(pointer);
  return cell.contains(place) ? fmt::format(fmt::runtime(form), cell.at(place).get<double>()) : "–";
}

std::string interval(const Json& cell, const char* key) {
  if (!cell.contains(key)) return "–";
  const Json& v = cell.at(key);
  return fmt::format("{:.4g} ({:.4g} to {:.4g})", v.at("value").get<double>(), v.at("low").get<double>(),
                     v.at("high").get<double>());
}

std::string table(const Json& stratum) {
  std::string text = fmt::format(
      "<details><summary>{}: every figure</summary><div "
      "class=\"scroll\"><table>\n<tr><th>variant</th><th>ns</th>"
      "<th>quartiles</th><th>ns, each waiting for the one before</th><th>of printed (95 "
      "%)</th><th>missed</th>"
      "<th>invented</th><th>moved</th><th>wrong per million (95 %)</th><th>log2 error p50</th><th>p99</th>"
      "<th>max seen</th></tr>\n",
      safe_text(stratum, "name"));
  for (const Json& cell : stratum.at("cells")) {
    text += fmt::format(
        "<tr><td>{}</td><td>{}</td><td>{} to {}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td>"
        "<td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
        safe_text(cell, "variant"), number(cell, "/ns/throughput/median", "{:.4g}"),
        number(cell, "/ns/throughput/q1", "{:.4g}"), number(cell, "/ns/throughput/q3", "{:.4g}"),
        number(cell, "/ns/latency/median", "{:.4g}"), interval(cell, "ratio"), json_text(cell.at("missed")),
        json_text(cell.at("invented")), json_text(cell.at("moved")), interval(cell, "wrong_per_million"),
        number(cell, "/log2_error/p50", "{:.1f}"), number(cell, "/log2_error/p99", "{:.1f}"),
        number(cell, "/log2_error/max", "{:.1f}"));
  }
  return text + "</table></div></details>\n";
}

std::string tangency_section(const Json& study) {
  std::string section;
  for (const Json& stratum : study.at("strata")) {
    if (stratum.at("name") != "graze") continue;
    section = kTangencyText + std::string("<div class=\"figures\">\n");
    for (const Selection& each : {kFormulas, kPrinted, kStable})
      section += tangency_figure(study, stratum, each);
    section += "</div>\n";
  }
  return section;
}

/// Links to the sections that the page has.
std::string contents(const std::string& page) {
  constexpr const char* kSections[][2] = {{"queries", "single questions"},
                                          {"responses", "responses"},
                                          {"runs", "whole runs"},
                                          {"grouping", "time of restitution"},
                                          {"revolution", "angle of revolution"},
                                          {"cases", "hard cases"}};
  std::string text = "<nav>";
  for (const auto& [id, name] : kSections) {
    if (page.find(fmt::format("<h2 id=\"{}\">", id)) == std::string::npos) continue;
    text += fmt::format("<a href=\"#{}\">{}</a> ", id, name);
  }
  return text + "</nav>\n";
}

std::string machine_text(const Json& study) {
  const Json& m = study.at("machine");
  return fmt::format("{}; {}; flags {}; tps {}.", safe_text(m, "processor"), safe_text(m, "compiler"),
                     safe_text(m, "flags"), safe_text(m, "version"));
}

std::string settings_text(const Json& study) {
  const Json& s = study.at("settings");
  return fmt::format("{} questions a stratum (seed {}), {} of them timed, {} interleaved repetitions. ",
                     json_text(s.at("questions")), json_text(s.at("seed")), json_text(s.at("timed")),
                     json_text(s.at("repetitions")));
}

/// Time against error, verdicts, condition, and every figure of the questions.
std::string questions_page(const Json& study) {
  std::string page = legend(study) + kParetoText + "<div class=\"figures\">\n";
  for (const Json& stratum : study.at("strata")) page += pareto_figure(study, stratum);
  page += "</div>\n" + tangency_section(study) + kConditionText + "<div class=\"figures\">\n";
  for (const Selection& each : {kFormulas, kPrinted, kStable}) page += condition_figure(study, each);
  page += "</div>\n<h2>Every figure</h2>\n";
  for (const Json& stratum : study.at("strata")) page += table(stratum);
  return page;
}

}  // namespace

std::string report_page(const Json& study) {
  const bool asks = study.contains("strata");
  const PlotScript script = plot_script();
  std::string page = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"/><meta "
      "http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'; "
      "script-src{}; base-uri 'none'; form-action 'none'\"/><meta name=\"viewport\" "
      "content=\"width=device-width\"/><title>What accuracy costs</title>\n<style>",
      script.text.empty() ? " 'none'" : view::source_hash(script.sha256));
  page += kStyle + colours() + "</style></head><body>\n<h1>What accuracy costs</h1>\n<p>";
  page += (asks ? settings_text(study) : "") + machine_text(study) + "</p>\n";
  page += script.text.empty() ? kWithoutVega : kHowToRead;
  const std::string sections = (asks ? questions_page(study) : "") + levels_page(study);
  page += contents(sections) + sections;
  return page + fmt::format("<script>{}</script>\n</body></html>\n", script.text);
}

}  // namespace tps::cost
