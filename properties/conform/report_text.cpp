#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "properties/conform/report.hpp"
#include "reference/text/printable.hpp"

namespace tps::properties::conform {
namespace {

constexpr std::array<const char*, 7> kAreas{"equations", "timing", "order",     "response",
                                            "grouping",  "engine", "whole runs"};

/// One line of the table: rows of one operation, or the laws of an area, together.
struct Line {
  std::string area, of;
  std::array<std::uint64_t, kClasses> counts{};
  std::optional<std::uint64_t> reference = 0;
  double units = 0, cond = 0;
  std::string page;
};

std::vector<Line> lines_of(const Verdict& verdict) {
  std::vector<Line> lines;
  for (const char* area : kAreas) {
    const std::size_t first = lines.size();
    for (const Row& row : verdict.rows) {
      if (row.area != area) continue;
      const auto same = std::find_if(lines.begin() + static_cast<std::ptrdiff_t>(first), lines.end(),
                                     [&](const Line& line) { return line.of == row.of; });
      Line& line =
          same != lines.end() ? *same : lines.emplace_back(Line{area, row.of, {}, 0, 0, 0, row.page});
      for (std::size_t c = 0; c < kClasses; ++c) line.counts[c] += row.counts[c];
      if (!row.reference) line.reference.reset();
      if (line.reference) *line.reference += *row.reference;
      if (row.worst_units * std::max(line.cond, 1.0) > line.units * std::max(row.worst_cond, 1.0)) {
        line.units = row.worst_units;
        line.cond = row.worst_cond;
      }
    }
  }
  return lines;
}

std::string number_or_dot(std::uint64_t n) {
  return n == 0 ? "." : fmt::format("{}", n);
}

std::string table(const Verdict& verdict) {
  std::string text = fmt::format("{:<11}{:<20}{:>6}", "", "", "asked");
  for (const ClassFacts& facts : kClassFacts) text += fmt::format("{:>9}", facts.brief);
  text += fmt::format("{:>10}  {:<17} {}\n", "reference", "worst, cond", "page");
  std::string area;
  for (const Line& line : lines_of(verdict)) {
    text += fmt::format("{:<11}{:<20}", line.area == area ? "" : line.area, line.of);
    area = line.area;
    std::uint64_t asked = 0;
    for (const std::uint64_t n : line.counts) asked += n;
    text += fmt::format("{:>6}", asked);
    for (const std::uint64_t n : line.counts) text += fmt::format("{:>9}", number_or_dot(n));
    if (line.of == "laws") {
      text += "\n";
      continue;
    }
    const bool scored = line.reference && line.area != "whole runs";
    const std::string worst = line.units > 0 ? fmt::format("{:.3g}, {:.2g}", line.units, line.cond)
                              : line.area == "whole runs" ? ""
                                                          : "–";
    text +=
        fmt::format("{:>10}  {:<17} {}\n", scored ? number_or_dot(*line.reference) : "", worst, line.page);
  }
  return text;
}

std::string example_text(const Example& e) {
  std::string text = fmt::format("    {}: {}\n", e.id, e.why);
  for (const std::string& command : e.commands) text += "      " + command + "\n";
  return text;
}

/// Rows of one operation, or a law, or what happened in runs, with answers of one class.
struct Group {
  std::string name;
  Class which;
  std::vector<const Row*> rows;
};

std::vector<Group> groups_of(const Verdict& verdict, Class which) {
  std::vector<Group> groups;
  for (const Row& row : verdict.rows) {
    if (row.of_class(which) == 0) continue;
    const std::string name = row.name == row.of + "." + row.hazard ? row.of : row.name;
    if (groups.empty() || groups.back().name != name) groups.push_back({name, which, {}});
    groups.back().rows.push_back(&row);
  }
  return groups;
}

/// "  block_time  4 of 150: touching 2, twins 2; docs/eq2.md"
std::string heading_of(const Group& group) {
  std::uint64_t found = 0, asked = 0, missed = 0;
  std::vector<std::string> hazards;
  for (const Row* row : group.rows) {
    found += row->of_class(group.which);
    asked += row->asked();
    if (row->reference) missed += row->asked() - *row->reference;
    hazards.push_back(fmt::format("{} {}", row->hazard, row->of_class(group.which)));
  }
  std::string text = fmt::format("  {:<20} {} of {}", group.name, found, asked);
  if (group.name == group.rows.front()->of) text += fmt::format(": {}", fmt::join(hazards, ", "));
  if (missed > 0) text += fmt::format("; the reference in these numbers misses {} as well", missed);
  return text + fmt::format("; {}\n", group.rows.front()->page);
}

std::string hypotheses_of(const Group& group) {
  if (group.which != Class::wrong) return {};
  Row all = *group.rows.front();
  for (std::size_t n = 1; n < group.rows.size(); ++n) {
    all.counts[index_of(Class::wrong)] += group.rows[n]->of_class(Class::wrong);
    for (const auto& [name, count] : group.rows[n]->hypotheses) all.hypotheses[name] += count;
  }
  const auto best = Verdict::best_hypotheses(all);
  if (best.empty()) return {};
  return fmt::format("    your answer equals: {} ({} of {})\n", fmt::join(best, "; or "),
                     all.hypotheses.at(best.front()), all.of_class(Class::wrong));
}

std::string group_text(const Group& group) {
  for (const Row* row : group.rows) {
    if (const auto& example = row->example_of(group.which))
      return heading_of(group) + hypotheses_of(group) + example_text(*example);
  }
  return heading_of(group) + hypotheses_of(group);
}

/// By class, the worst first.
std::string findings_text(const Verdict& verdict) {
  std::string text;
  for (std::size_t c = kClasses; c-- > index_of(Class::not_bitwise);) {
    const auto groups = groups_of(verdict, kClassFacts[c].which);
    if (!groups.empty()) text += fmt::format("{}\n", kClassFacts[c].name);
    for (const Group& group : groups) text += group_text(group);
  }
  return text;
}

std::string every_row_text(const Verdict& verdict) {
  std::string text;
  for (const Row& row : verdict.rows)
    text += fmt::format("  {:<34} {}; {}\n", row.name, findings_of(row), row.page);
  return text;
}

std::string environment_text(const Environment& e) {
  if (e.bits_seen == 0) return {};
  std::string text =
      fmt::format("judged as numbers of {} bits; answers had up to {} bits", e.bits, e.bits_seen);
  if (e.exact)
    text += *e.exact ? "; numbers arrive with all their bits" : "; numbers do NOT arrive with all their bits";
  if (e.flushes)
    text += *e.flushes ? "; subnormal numbers are flushed to zero" : "; subnormal numbers are kept";
  if (e.contracts) text += *e.contracts ? "; products are contracted (FMA)" : "; products are not contracted";
  return text + "\n";
}

}  // namespace

std::string words_of(const Failure& failure) {
  return failure.at + ": " + failure.reason;
}

std::string findings_of(const Row& row) {
  std::string text = fmt::format("{} asked", row.asked());
  for (std::size_t c = 0; c < kClasses; ++c) {
    if (row.counts[c] > 0) text += fmt::format(", {} {}", row.counts[c], kClassFacts[c].name);
  }
  if (row.reference && *row.reference < row.asked())
    text += fmt::format(" (the reference in these numbers: {} right or to rounding)", *row.reference);
  return text;
}

std::string sentence(const Verdict& verdict) {
  const std::string subject = printable(verdict.subject);
  if (verdict.interrupted) return subject + ": interrupted, no verdict";
  if (verdict.failed > 0) {
    return fmt::format("{}: no verdict, since it failed {} times: {}", subject, verdict.failed,
                       verdict.failures.empty() ? "" : words_of(verdict.failures.front()));
  }
  if (verdict.asked() == 0) return subject + ": no verdict, since nothing was asked of it";
  const auto failing = verdict.failing();
  const auto passes = verdict.unexpected_passes();
  const std::string by = fmt::format("by profile {}, {} judged", verdict.profile.name, verdict.asked());
  if (failing.empty() && passes.empty()) {
    const auto counts = verdict.counts();
    const std::uint64_t fine = counts[0] + counts[1];
    return fmt::format("{}: conforming {}{}; {} right or to rounding{}", subject,
                       verdict.notes.contains("time") ? "as far as it was asked, " : "", by, fine,
                       fine == verdict.asked() ? "" : ", the rest is explained above");
  }
  std::vector<std::string> names;
  for (const Row* row : failing) {
    const std::string& what = row->of == "laws" || row->of == "runs" ? row->name : row->of;
    if (names.empty() || names.back() != what) names.push_back(what);
  }
  constexpr std::size_t kShown = 6;
  const std::size_t hidden = names.size() > kShown ? names.size() - kShown : 0;
  names.resize(names.size() - hidden);
  std::string text = fmt::format("{}: NOT conforming {}", subject, by);
  if (!names.empty()) text += fmt::format("; what fails: {}", fmt::join(names, ", "));
  if (hidden > 0) text += fmt::format(" and {} more", hidden);
  if (!passes.empty()) text += fmt::format("; expected to fail but passes: {}", fmt::join(passes, ", "));
  for (const std::string& pattern : passes) {
    if (!verdict.has_row(pattern))
      text += fmt::format(" ({} is no row that was asked; --all shows their names)", pattern);
  }
  return text;
}

std::string report_text(const Verdict& verdict, bool every_row) {
  std::string text = table(verdict);
  if (every_row) text += every_row_text(verdict);
  text += findings_text(verdict);
  for (const Failure& failure : verdict.failures) {
    text += "FAILED " + words_of(failure) + "\n";
    for (const std::string& command : failure.commands) text += "      " + command + "\n";
  }
  text += environment_text(verdict.environment);
  if (!verdict.not_offered.empty())
    text += fmt::format("not offered, so not asked: {}\n", fmt::join(verdict.not_offered, ", "));
  if (!verdict.laws_not_asked.empty())
    text += fmt::format("not asked either: {}\n", laws_not_asked_in_words(verdict));
  for (const auto& [key, note] : verdict.notes) text += fmt::format("{}: {}\n", key, note);
  return printable_lines(text) + sentence(verdict) + "\n";
}

int exit_code(const Verdict& verdict) {
  if (verdict.interrupted) return 130;
  if (verdict.failed > 0) return 4;
  if (!verdict.failing().empty() || !verdict.unexpected_passes().empty()) return 1;
  return verdict.asked() == 0 ? 5 : 0;
}

}  // namespace tps::properties::conform
