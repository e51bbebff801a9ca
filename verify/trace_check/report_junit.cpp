#include <fmt/format.h>

#include <iterator>

#include "reference/text/printable.hpp"
#include "verify/trace_check/report.hpp"

namespace tps::check {
namespace {

std::string details_of(const CheckReport& report, Rule rule, Outcome outcome) {
  std::string text;
  for (const Finding& f : report.findings) {
    if (f.rule != rule || f.outcome != outcome) continue;
    fmt::format_to(std::back_inserter(text), "{}:{}: {}\n", printable(report.file), f.line,
                   printable(f.message));
  }
  return text;
}

}  // namespace

std::string report_junit(const CheckReport& r) {
  std::size_t failures = 0;
  std::size_t skipped = 0;
  std::string cases;
  const auto out = std::back_inserter(cases);
  for (const RuleResult& rule : r.rules) {
    const std::string_view rule_name = name(rule.rule);
    fmt::format_to(out, "  <testcase classname=\"tps.check\" name=\"{}\"", rule_name);
    if (rule.violated > 0) {
      ++failures;
      fmt::format_to(out, "><failure message=\"{} violated\">{}</failure></testcase>\n", rule.violated,
                     xml_text(details_of(r, rule.rule, Outcome::violated)));
    } else if (rule.passed == 0 || rule.undecided > 0) {
      ++skipped;
      const std::string why = rule.undecided > 0        ? fmt::format("{} undecided", rule.undecided)
                              : rule.not_judged.empty() ? std::string("nothing of the kind happened")
                                                        : rule.not_judged;
      fmt::format_to(out, "><skipped message=\"{}\"/></testcase>\n", xml_text(why));
    } else if (!rule.not_judged.empty()) {
      fmt::format_to(out, "><system-out>not judged: {}</system-out></testcase>\n", xml_text(rule.not_judged));
    } else {
      cases += "/>\n";
    }
  }
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" "
      "skipped=\"{}\" "
      "time=\"{:.3f}\">\n{}</testsuite>\n",
      xml_text(printable(r.file)), kRules, failures, skipped, r.seconds, cases);
}

}  // namespace tps::check
