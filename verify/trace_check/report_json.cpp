#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "reference/text/plain_json.hpp"
#include "verify/trace_check/report.hpp"

namespace tps::check {
namespace {

using Json = nlohmann::ordered_json;

Json rule_json(const RuleResult& rule) {
  Json result{{"rule", name(rule.rule)},
              {"passed", rule.passed},
              {"violated", rule.violated},
              {"undecided", rule.undecided}};
  if (rule.worst_allowed > 0)
    result["largest_share"] = {{"off_ulps", rule.worst_off}, {"allowed_ulps", rule.worst_allowed}};
  if (!rule.not_judged.empty()) result["not_judged"] = rule.not_judged;
  return result;
}

Json finding_json(const Finding& f) {
  Json result{{"rule", name(f.rule)},
              {"outcome", f.outcome == Outcome::violated ? "violated" : "undecided"},
              {"line", f.line},
              {"event", f.event},
              {"t", f.t},
              {"particles", f.particles},
              {"message", f.message}};
  if (!f.equation.empty()) result["equation"] = f.equation;
  if (!f.reading.empty()) result["reading"] = f.reading;
  result["page"] = fmt::format("docs/check.md#{}", name(f.rule));
  if (f.off) result["off_ulps"] = *f.off;
  if (f.allowed) result["allowed_ulps"] = *f.allowed;
  if (f.replay)
    result["replay"] = {{"op", operations::name(f.replay->op)}, {"in", Json::parse(f.replay->in)}};
  return result;
}

}  // namespace

std::string report_json(const CheckReport& r) {
  Json rules = Json::array();
  for (const RuleResult& rule : r.rules) rules.push_back(rule_json(rule));
  Json findings = Json::array();
  for (const Finding& finding : r.findings) findings.push_back(finding_json(finding));
  Json sums = Json::array();
  for (const ResidualSum& s : r.sums) {
    sums.push_back({{"of", s.of},
                    {"count", s.count},
                    {"mean_ulps", s.mean},
                    {"standard_error_ulps", s.standard_error},
                    {"independent", s.independent}});
  }
  const Json result{{"trace", r.file},
                    {"title", r.title},
                    {"scalar", r.scalar},
                    {"timing", r.timing},
                    {"form", r.minimal ? "minimal" : "full"},
                    {"particles", r.particles},
                    {"lines", r.lines},
                    {"events", r.events},
                    {"states", r.states},
                    {"segments", r.segments},
                    {"end", r.end},
                    {"interrupted", r.interrupted},
                    {"tolerance", r.tolerance},
                    {"conforming", r.conforming()},
                    {"inconclusive", r.inconclusive()},
                    {"partial", r.partial()},
                    {"violated", r.violated()},
                    {"undecided", r.undecided()},
                    {"certified_comparisons", r.certified_comparisons},
                    {"seconds", r.seconds},
                    {"rules", rules},
                    {"findings", findings},
                    {"residuals", sums},
                    {"notes", r.notes}};
  return json_text(result, 2) + "\n";
}

}  // namespace tps::check
