#include <fmt/format.h>
#include <fmt/ranges.h>

#include "properties/conform/drawing.hpp"
#include "properties/conform/report.hpp"
#include "reference/text/printable.hpp"

namespace tps::properties::conform {
namespace {

constexpr const char* kHead = R"(<!doctype html>
<html lang="en"><head><meta charset="utf-8"><title>tps conform</title><style>
body{font:15px/1.45 system-ui,sans-serif;max-width:75em;margin:2em auto;padding:0 1em;color:#222}
table{border-collapse:collapse}td,th{padding:.15em .6em;text-align:right;border-bottom:1px solid #ddd}
td:first-child,th:first-child{text-align:left}tr.fails td:first-child{color:#b71c1c;font-weight:600}
section{display:flex;gap:1.5em;border-top:1px solid #ddd;padding:1em 0}code{overflow-wrap:anywhere}
svg{flex:none;background:#fafafa}svg text{font-size:11px}.limit{fill:none;stroke:#999}.path{stroke:#999}
.body{fill:#222}.right{fill:#2e7d32;stroke:#2e7d32}.found{fill:#b71c1c;stroke:#b71c1c}
</style></head><body>
)";

std::string table_row(const Verdict& verdict, const Row& row) {
  std::string text =
      fmt::format("<tr{}><td>{}</td><td>{}</td>", verdict.profile.accepts(row) ? "" : " class=\"fails\"",
                  xml_text(row.name), row.asked());
  for (const std::uint64_t count : row.counts)
    text += count > 0 ? fmt::format("<td>{}</td>", count) : "<td></td>";
  return text + fmt::format("<td>{}</td></tr>\n", row.reference ? fmt::format("{}", *row.reference) : "");
}

std::string html_table(const Verdict& verdict) {
  std::string text = "<table><tr><th></th><th>asked</th>";
  for (const ClassFacts& facts : kClassFacts) text += fmt::format("<th>{}</th>", facts.brief);
  text += "<th>reference</th></tr>\n";
  for (const Row& row : verdict.rows) text += table_row(verdict, row);
  return text + "</table>\n";
}

std::string commands_of(const std::vector<std::string>& commands) {
  std::string text;
  for (const std::string& command : commands)
    text += fmt::format("<p><code>{}</code></p>", xml_text(command));
  return text;
}

std::string case_of(const Row& row, const Example& e) {
  const auto best = Verdict::best_hypotheses(row);
  std::string text = fmt::format("<section>{}<div><h3>{}: {}</h3><p>{}: {}</p>", drawing_of(e),
                                 xml_text(row.name), name(e.which), xml_text(e.id), xml_text(e.why));
  if (!best.empty())
    text +=
        fmt::format("<p>Your answer equals: {}.</p>", xml_text(fmt::format("{}", fmt::join(best, "; or "))));
  return text + commands_of(e.commands) + "</div></section>\n";
}

}  // namespace

std::string report_html(const Verdict& verdict) {
  std::string text = kHead;
  text += fmt::format("<h1>tps conform</h1>\n<p><strong>{}</strong></p>\n", xml_text(sentence(verdict)));
  for (const Failure& failure : verdict.failures)
    text += fmt::format("<p>Failed: {}</p>{}\n", xml_text(words_of(failure)), commands_of(failure.commands));
  text += html_table(verdict);
  for (std::size_t c = kClasses; c-- > index_of(Class::other_reading);) {
    for (const Row& row : verdict.rows) {
      const Example* worst = row.worst_example();
      if (worst != nullptr && worst->which == kClassFacts[c].which) text += case_of(row, *worst);
    }
  }
  return text + fmt::format("<p>Profile {}, {}.</p>\n</body></html>\n", xml_text(verdict.profile.name),
                            xml_text(verdict.data));
}

}  // namespace tps::properties::conform
