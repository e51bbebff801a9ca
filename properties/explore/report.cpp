#include "properties/explore/report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <map>
#include <sstream>

#include "reference/text/number_text.hpp"
#include "reference/text/plain_json.hpp"
#include "reference/text/printable.hpp"

namespace tps::properties {
namespace {

std::vector<std::string_view> operation_names(const Law& law) {
  std::vector<std::string_view> names;
  for (const Op op : law.operations) names.push_back(operations::name(op));
  return names;
}

std::string shown(const Case& c) {
  std::ostringstream text;
  text << c;
  return text.str();
}

/// Decimal where that is short and exact.
std::string word_of(const Json& number) {
  const std::string hex = number.get<std::string>();
  if (hex == "inf") return hex;
  const std::string decimal = fmt::format("{}", parse_hex_float(hex).value);
  return decimal.size() < hex.size() ? decimal : hex;
}

Json law_json(const LawText& text) {
  return {{"id", text.id}, {"number", text.number}, {"sentence", text.sentence}, {"page", text.page}};
}

const char* word_for(const Outcome& outcome) {
  if (outcome.kind == Outcome::Kind::failed) return "failed";
  return outcome.kind == Outcome::Kind::refused ? "refused" : "broken";
}

const char* loud_word_for(const Outcome& outcome) {
  if (outcome.kind == Outcome::Kind::failed) return "FAILED";
  return outcome.kind == Outcome::Kind::refused ? "REFUSED" : "BROKEN";
}

Json finding_json(const Finding& finding) {
  Json questions = Json::array();
  for (const Question& question : finding.questions)
    questions.push_back({{"op", operations::name(question.op)}, {"in", question.in}});
  return {{"kind", word_for(finding.outcome)},
          {"why", finding.outcome.why},
          {"number", finding.number},
          {"shrinks", finding.shrinks},
          {"case", case_json(finding.shrunk)},
          {"generated", case_json(finding.generated)},
          {"questions", questions}};
}

std::map<std::string, std::uint64_t> counted_hazards(const Exploration& exploration) {
  std::map<std::string, std::uint64_t> sums;
  for (const LawReport& report : exploration.laws) {
    for (const auto& [hazard, count] : report.tally.hazards) sums[hazard] += count;
  }
  return sums;
}

std::size_t broken_in(const Exploration& exploration) {
  const std::vector<const Finding*> findings = exploration.findings();
  return static_cast<std::size_t>(std::count_if(findings.begin(), findings.end(), [](const Finding* finding) {
    return finding->outcome.kind != Outcome::Kind::refused;
  }));
}

std::string refused_in(const Exploration& exploration) {
  std::uint64_t refused = 0;
  for (const LawReport& report : exploration.laws) refused += report.tally.refused;
  return refused > 0 ? fmt::format(", questions refused {}", refused) : "";
}

/// A broken law is not asked any case behind the one that broke it.
std::string where_to_go_on(const Exploration& exploration) {
  const auto numbered = [&](std::uint64_t first) {
    return fmt::format("--seed {} --first {}", exploration.plan.seed, first);
  };
  std::optional<std::uint64_t> broken;
  bool any_open = false;
  for (const LawReport& report : exploration.laws) {
    if (report.is_broken())
      broken = std::min(broken.value_or(report.finding->number), report.finding->number);
    any_open = any_open || !report.is_done();
  }
  if (!broken) return "go on with " + numbered(exploration.next);
  const std::string mended = "once what is broken is mended, with " + numbered(*broken);
  return any_open ? fmt::format("go on with {}, or, {}", numbered(exploration.next), mended)
                  : "go on, " + mended;
}

std::string state_of(const LawReport& report) {
  if (report.finding) return loud_word_for(report.finding->outcome);
  if (report.tally.skipped > 0) return "not offered";
  if (report.tally.rounding > 0) return "to rounding";
  return report.tally.held > 0 ? "holds" : "not met";
}

}  // namespace

std::string command_of(const Question& question) {
  std::string text = fmt::format("tps eval {}", operations::name(question.op));
  // Words on the command line are numbers and lists of numbers.
  const bool is_plain = std::all_of(question.in.begin(), question.in.end(), [](const Json& value) {
    return value.is_string() || (value.is_array() && !value.empty() && value[0].is_string());
  });
  if (!is_plain) return fmt::format("echo '{}' | {} --in -", json_text(question.in), text);
  for (const auto& [key, value] : question.in.items()) {
    text += fmt::format(" {}=", key);
    if (!value.is_array()) {
      text += word_of(value);
      continue;
    }
    for (std::size_t k = 0; k < value.size(); ++k) text += (k > 0 ? "," : "") + word_of(value[k]);
  }
  return text;
}

std::string list_text(const std::vector<const Law*>& laws) {
  std::string text;
  for (const Law* law : laws) {
    fmt::format_to(std::back_inserter(text), "{:<22} {}\n{:<22} {}; {} ({})\n", law->text.number,
                   law->text.id, "", law->text.sentence, law->text.page,
                   fmt::join(operation_names(*law), ", "));
  }
  return text;
}

std::string list_json(const std::vector<const Law*>& laws) {
  Json list = Json::array();
  for (const Law* law : laws) {
    list.push_back(law_json(law->text));
    list.back()["operations"] = operation_names(*law);
  }
  return json_text(list, 1) + "\n";
}

std::string finding_text(const Finding& finding, const Plan& plan) {
  const LawText& law = finding.law->text;
  std::string text = fmt::format(
      "{} {}: {}\n  {}, {}\n  {}\n  shrunk:    {}\n  generated: {} (case {} of seed {}, {} shrinks before)\n",
      loud_word_for(finding.outcome), law.number, law.sentence, law.id, law.page, finding.outcome.why,
      shown(finding.shrunk), shown(finding.generated), finding.number, plan.seed, finding.shrinks);
  for (const Question& question : finding.questions) text += "  " + command_of(question) + "\n";
  return printable_lines(text);
}

std::string replay_text(const Replayed& replay) {
  std::string text;
  for (const Finding& finding : replay.findings) text += finding_text(finding, {});
  return text + fmt::format("{}: {} cases hold, {} broken, {} not asked\n", replay.subject, replay.held,
                            replay.findings.size(), replay.not_asked);
}

std::string replay_json(const Replayed& replay) {
  Json findings = Json::array();
  for (const Finding& finding : replay.findings) {
    findings.push_back(law_json(finding.law->text));
    findings.back()["finding"] = finding_json(finding);
  }
  return json_text(Json{{"subject", replay.subject},
                        {"held", replay.held},
                        {"broken", replay.findings.size()},
                        {"not_asked", replay.not_asked},
                        {"findings", findings}},
                   1) +
         "\n";
}

std::string exploration_text(const Exploration& exploration) {
  std::string text;
  for (const LawReport& report : exploration.laws) {
    const std::string refused =
        report.tally.refused > 0 ? fmt::format("{:>5} refused  ", report.tally.refused) : "";
    fmt::format_to(std::back_inserter(text), "{:<22} {:<12} {:>7} held {:>7} outside  {}{}\n",
                   report.law->text.number, state_of(report), report.tally.held, report.tally.outside,
                   refused, report.law->text.id);
  }
  if (exploration.held() > 0) text += "cases held by hazard:";
  for (const auto& [hazard, count] : counted_hazards(exploration))
    text += fmt::format(" {} {},", hazard, count);
  if (exploration.held() > 0) text.back() = '\n';
  for (const LawReport& report : exploration.laws) {
    if (report.tally.rounding == 0) continue;
    text += fmt::format("{} holds to rounding, not bitwise, in {} of {} cases ({}): {}\n",
                        report.law->text.number, report.tally.rounding, report.tally.held,
                        report.law->text.id, report.tally.in_last_bits);
  }
  for (const Finding* finding : exploration.findings()) text += finding_text(*finding, exploration.plan);
  return printable_lines(text) + fmt::format("{}: laws {}, cases held {}, broken {}{}; {}\n",
                                             printable(exploration.subject), exploration.laws.size(),
                                             exploration.held(), broken_in(exploration),
                                             refused_in(exploration), where_to_go_on(exploration));
}

std::string exploration_json(const Exploration& exploration) {
  Json reports = Json::array();
  for (const LawReport& report : exploration.laws) {
    Json one = law_json(report.law->text);
    one["state"] = state_of(report);
    one["held"] = report.tally.held;
    one["outside"] = report.tally.outside;
    one["refused"] = report.tally.refused;
    one["to_rounding"] = report.tally.rounding;
    if (report.tally.rounding > 0) one["in_last_bits"] = report.tally.in_last_bits;
    if (report.tally.held == 0) one["why_not"] = report.tally.why_not;
    one["hazards"] = report.tally.hazards;
    if (report.finding) one["finding"] = finding_json(*report.finding);
    reports.push_back(one);
  }
  return json_text(Json{{"subject", exploration.subject},
                        {"seed", exploration.plan.seed},
                        {"first", exploration.plan.first},
                        {"next", exploration.next},
                        {"hazards", counted_hazards(exploration)},
                        {"laws", reports}},
                   1) +
         "\n";
}

}  // namespace tps::properties
