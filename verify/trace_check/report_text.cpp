#include <fmt/format.h>

#include <iterator>
#include <utility>

#include "reference/text/printable.hpp"
#include "verify/trace_check/report.hpp"
#include "verify/trace_check/segment_size.hpp"

namespace tps::check {
namespace {

constexpr std::size_t kLongestTitle = 200;

std::string verdict_of(const RuleResult& rule) {
  if (rule.violated > 0) return "VIOLATED";
  if (rule.undecided > 0) return "undecided";
  if (rule.passed > 0) return "pass";
  return rule.not_judged.empty() ? "no case" : "not judged";
}

/// Two margins in as many digits as it takes to tell them apart.
std::pair<std::string, std::string> told_apart(double a, double b) {
  for (const int digits : {3, 9}) {
    std::string of_a = fmt::format("{:.{}g}", a, digits);
    std::string of_b = fmt::format("{:.{}g}", b, digits);
    if (of_a != of_b) return {std::move(of_a), std::move(of_b)};
  }
  return {fmt::format("{:.17g}", a), fmt::format("{:.17g}", b)};
}

std::string margin_of(const RuleResult& rule) {
  if (rule.worst_allowed == 0) return "";
  return fmt::format("{:.3g} of {:.3g} ulp", rule.worst_off, rule.worst_allowed);
}

void add_finding(std::string& text, const Finding& f) {
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "\nline {}", f.line);
  if (f.event > 0) fmt::format_to(out, ", event {}", f.event);
  if (!f.t.empty()) fmt::format_to(out, ", t = {}", printable(f.t));
  fmt::format_to(out, ": {}{}\n  {}\n", name(f.rule), f.outcome == Outcome::undecided ? " (undecided)" : "",
                 printable(f.message));
  if (f.off) {
    const auto [off, allowed] = told_apart(*f.off, *f.allowed);
    fmt::format_to(out, "  off by {} ulp, allowed {}\n", off, allowed);
  }
  if (!f.reading.empty())
    fmt::format_to(out, "  another reading of the paper, decision {}; see docs/decisions.md\n", f.reading);
  if (!f.particles.empty()) fmt::format_to(out, "  particles {}\n", fmt::join(f.particles, " "));
  fmt::format_to(out, "  {}see docs/check.md, {}\n", f.equation.empty() ? "" : "eq. " + f.equation + "; ",
                 name(f.rule));
}

}  // namespace

std::string report_text(const CheckReport& r) {
  std::string text;
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "trace      {}: {} ({} particles, {}, {}{})\n", printable(r.file),
                 printable(r.title, kLongestTitle), r.particles, r.scalar, r.timing,
                 r.minimal ? ", minimal" : "");
  fmt::format_to(out, "lines      {}: {} events, {} full states, end {}\n", r.lines, r.events, r.states,
                 r.end.empty() ? "missing" : printable(r.end));
  if (r.segments > 1) {
    fmt::format_to(out, "segments   {}, each judged from its full state\n", r.segments);
  } else if (r.lines > kLinesOfSegment) {
    fmt::format_to(out, "segments   1: no full state from which another could begin alone\n");
  }
  if (r.tolerance != 1) fmt::format_to(out, "tolerance  {} times the derived bounds\n", r.tolerance);
  fmt::format_to(out, "{:<13} {:<10}{:>10}{:>10}{:>10}  {}\n", "rule", "verdict", "passed", "violated",
                 "undecided", "largest share of its bound");
  for (const RuleResult& rule : r.rules) {
    const std::string line =
        fmt::format("{:<13} {:<10}{:>10}{:>10}{:>10}  {}", name(rule.rule), verdict_of(rule), rule.passed,
                    rule.violated, rule.undecided, margin_of(rule));
    fmt::format_to(out, "{}\n", line.substr(0, line.find_last_not_of(' ') + 1));
  }
  for (const RuleResult& rule : r.rules) {
    if (!rule.not_judged.empty())
      fmt::format_to(out, "not judged {}: {}\n", name(rule.rule), rule.not_judged);
  }
  for (const ResidualSum& sum : r.sums) {
    fmt::format_to(out, "residuals  {}: mean {:+.4f} ulp, standard error {:.4f}, of {}\n", sum.of, sum.mean,
                   sum.standard_error, sum.count);
  }
  for (const std::string& note : r.notes) fmt::format_to(out, "note       {}\n", note);
  for (const Finding& finding : r.findings) add_finding(text, finding);
  if (r.interrupted) {
    fmt::format_to(out, "\ninterrupted after line {}: what follows was not judged\n", r.lines);
  } else if (!r.conforming()) {
    fmt::format_to(out, "\n{} steps violate a rule\n", r.violated());
  } else if (r.inconclusive()) {
    fmt::format_to(out, "\nnothing is violated, but {} steps are undecided: more than one in a hundred\n",
                   r.undecided());
  } else {
    const std::string aside =
        r.undecided() == 0 ? std::string() : fmt::format(", {} undecided aside", r.undecided());
    fmt::format_to(out, "{}{}\n",
                   r.partial() ? "conforming in what could be judged: see \"not judged\" above"
                               : "conforming: every step follows from the one before",
                   aside);
  }
  return text;
}

}  // namespace tps::check
