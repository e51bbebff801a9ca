#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

#include "properties/conform/report.hpp"
#include "reference/text/plain_json.hpp"
#include "reference/text/printable.hpp"

namespace tps::properties::conform {
namespace {

Json counts_json(const std::array<std::uint64_t, kClasses>& counts) {
  Json json = Json::object();
  for (std::size_t c = 0; c < kClasses; ++c) json[std::string(kClassFacts[c].name)] = counts[c];
  return json;
}

Json row_json(const Verdict& verdict, const Row& row) {
  Json json{{"name", row.name},
            {"area", row.area},
            {"of", row.of},
            {"hazard", row.hazard},
            {"page", row.page},
            {"asked", row.asked()},
            {"classes", counts_json(row.counts)},
            {"accepted", verdict.profile.accepts(row)}};
  if (row.reference) json["reference"] = *row.reference;
  if (row.worst_units > 0) json["worst"] = {{"units", row.worst_units}, {"cond", row.worst_cond}};
  if (!row.hypotheses.empty()) json["hypotheses"] = row.hypotheses;
  if (const auto best = Verdict::best_hypotheses(row); !best.empty()) json["equals"] = best;
  if (const Example* worst = row.worst_example()) {
    const Example& e = *worst;
    json["example"] = {{"class", name(e.which)}, {"id", e.id}, {"why", e.why}, {"commands", e.commands}};
    if (!e.in.empty()) json["example"]["in"] = Json::parse(e.in);
  }
  return json;
}

Json environment_json(const Environment& e) {
  const auto known = [](const std::optional<bool>& fact) { return fact ? Json(*fact) : Json(); };
  return {{"bits", e.bits},
          {"bits_seen", e.bits_seen},
          {"exact", known(e.exact)},
          {"flushes", known(e.flushes)},
          {"contracts", known(e.contracts)},
          {"seconds", e.seconds},
          {"cpu_seconds", e.cpu_seconds}};
}

const char* word_of(const Verdict& verdict) {
  switch (exit_code(verdict)) {
    case 0:
      return "conforming";
    case 1:
      return "not conforming";
    default:
      return "no verdict";
  }
}

}  // namespace

std::string report_json(const Verdict& verdict) {
  Json rows = Json::array();
  for (const Row& row : verdict.rows) rows.push_back(row_json(verdict, row));
  Json fails = Json::array();
  for (std::size_t c = 0; c < kClasses; ++c) {
    if (verdict.profile.fails[c]) fails.push_back(kClassFacts[c].name);
  }
  Json failures = Json::array(), failed_at = Json::array(), laws = Json::array();
  for (const Failure& failure : verdict.failures) {
    failures.push_back(words_of(failure));
    failed_at.push_back({{"at", failure.at}, {"commands", failure.commands}});
  }
  for (const LawNotAsked& law : verdict.laws_not_asked)
    laws.push_back({{"law", law.number}, {"needs", law.needs}});
  const Environment& e = verdict.environment;
  return json_text(Json{{"conform", 1},
                        {"subject", verdict.subject},
                        {"data", verdict.data},
                        {"profile", {{"name", verdict.profile.name}, {"fails", fails}}},
                        {"environment", environment_json(e)},
                        {"asked", verdict.asked()},
                        {"classes", counts_json(verdict.counts())},
                        {"not_offered", verdict.not_offered},
                        {"laws_not_asked", laws},
                        {"failed", verdict.failed},
                        {"failures", failures},
                        {"failed_at", failed_at},
                        {"notes", verdict.notes},
                        {"unexpected_passes", verdict.unexpected_passes()},
                        {"rows", rows},
                        {"verdict", word_of(verdict)},
                        {"exit_code", exit_code(verdict)},
                        {"sentence", sentence(verdict)}},
                   1) +
         "\n";
}

/// A test case a row; a row that may fail and does is skipped, as CI systems have it.
std::string report_junit(const Verdict& verdict) {
  std::string cases;
  std::size_t failures = 0, skipped = 0;
  for (const Row& row : verdict.rows) {
    cases += fmt::format("  <testcase classname=\"{}\" name=\"{}\"", xml_text(row.area), xml_text(row.name));
    if (verdict.profile.accepts(row)) {
      cases += "/>\n";
      continue;
    }
    const Example* worst = row.worst_example();
    const std::string detail = worst != nullptr ? worst->id + ": " + worst->why : "";
    if (verdict.expected_to_fail(row)) {
      ++skipped;
      cases += fmt::format(">\n    <skipped message=\"{}\"/>\n  </testcase>\n",
                           xml_text("expected: " + findings_of(row)));
    } else {
      ++failures;
      cases += fmt::format(">\n    <failure message=\"{}\">{}</failure>\n  </testcase>\n",
                           xml_text(findings_of(row)), xml_text(detail));
    }
  }
  const auto failed = [&](const std::string& name, const std::string& message) {
    ++failures;
    cases += fmt::format(
        "  <testcase classname=\"conform\" name=\"{}\">\n    <failure message=\"{}\"/>\n  </testcase>\n",
        xml_text(name), xml_text(message));
  };
  for (const std::string& pattern : verdict.unexpected_passes())
    failed(pattern, "expected to fail, but passes");
  if (verdict.failed > 0) failed("protocol", sentence(verdict));
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuite name=\"tps conform {}\" tests=\"{}\" "
      "failures=\"{}\" "
      "skipped=\"{}\">\n{}</testsuite>\n",
      xml_text(verdict.subject),
      verdict.rows.size() + verdict.unexpected_passes().size() + (verdict.failed > 0 ? 1 : 0), failures,
      skipped, cases);
}

namespace {

/// One line that Markdown shows as it is: no tags, links or emphasis, and one cell of a table.
std::string cell(std::string_view text) {
  std::string shown;
  for (const char c : printable(text)) {
    if (c == '&' || c == '<' || c == '>') {
      shown += c == '&' ? "&amp;" : c == '<' ? "&lt;" : "&gt;";
    } else {
      if (std::string_view("|`*[]").find(c) != std::string_view::npos) shown += '\\';
      shown += c;
    }
  }
  return shown;
}

}  // namespace

std::string report_markdown(const Verdict& verdict) {
  std::string text = fmt::format("### tps conform: {}\n\n{}\n", word_of(verdict), cell(sentence(verdict)));
  const auto counts = verdict.counts();
  text += "\n| class | answers |\n|---|---|\n";
  for (std::size_t c = 0; c < kClasses; ++c) {
    if (counts[c] > 0) text += fmt::format("| {} | {} |\n", kClassFacts[c].name, counts[c]);
  }
  std::string rows;
  for (const Row& row : verdict.rows) {
    if (verdict.profile.accepts(row)) continue;
    const std::string best = fmt::format("{}", fmt::join(Verdict::best_hypotheses(row), "; or "));
    const Example* worst = row.worst_example();
    rows += fmt::format("| {} | {} | {} | {} |\n", cell(row.name), cell(findings_of(row)), cell(best),
                        worst != nullptr ? cell(worst->why) : "");
  }
  if (!rows.empty()) text += "\n| row | asked and found | equals | first case |\n|---|---|---|---|\n" + rows;
  return text + fmt::format("\nProfile {}, {}.\n", cell(verdict.profile.name), verdict.data);
}

std::string report_svg(const Verdict& verdict) {
  const std::string left = fmt::format("TPS {}", verdict.profile.name);
  const std::string right = fmt::format("{}, {}", word_of(verdict), verdict.data);
  const int code = exit_code(verdict);
  const char* colour = code == 0 ? "#2e7d32" : code == 1 ? "#b71c1c" : "#616161";
  // 6.5 units a letter of 11 units, with a margin of 6 on each side
  const auto width = [](const std::string& text) { return static_cast<int>(text.size()) * 13 / 2 + 12; };
  const int a = width(left), b = width(right);
  return fmt::format(
      R"(<svg xmlns="http://www.w3.org/2000/svg" width="{0}" height="20" role="img" aria-label="{3}: {4}">
<title>{3}: {4}</title>
<rect width="{1}" height="20" fill="#424242"/><rect x="{1}" width="{2}" height="20" fill="{5}"/>
<g fill="#fff" font-family="Verdana,sans-serif" font-size="11" text-anchor="middle">
<text x="{6}" y="14">{3}</text><text x="{7}" y="14">{4}</text></g>
</svg>
)",
      a + b, a, b, xml_text(left), xml_text(right), colour, a / 2, a + b / 2);
}

}  // namespace tps::properties::conform
