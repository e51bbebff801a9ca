#include "properties/conform/ask_runs.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "properties/conform/random_scene.hpp"
#include "properties/conform/trace_features.hpp"
#include "properties/runs/scratch_file.hpp"
#include "reference/scene/write_scene.hpp"
#include "reference/text/input_error.hpp"
#include "verify/trace_check/check.hpp"

namespace tps::properties::conform {
namespace {

constexpr const char* kPage = "docs/check.md";
constexpr const char* kArea = "whole runs";
constexpr int kMostFailures = 5;

/// A reading is defensible where the paper is silent (docs/decisions.md, N104).
bool is_defensible(const std::string& reading) {
  constexpr std::array<const char*, 5> kSilent{"D9:", "D11:", "D12:", "D13:", "D16:"};
  return std::any_of(kSilent.begin(), kSilent.end(), [&](const char* d) { return reading.starts_with(d); });
}

Class class_of(const check::Finding& finding) {
  if (finding.outcome == check::Outcome::undecided) return Class::beyond;
  if (is_defensible(finding.reading)) return Class::other_reading;
  return finding.message.starts_with("creep:") ? Class::worse : Class::wrong;
}

std::string words_of(const check::Finding& f) {
  std::string text = fmt::format("line {}, {}: {}", f.line, check::name(f.rule), f.message);
  if (f.off && f.allowed) text += fmt::format("; off by {:.3g} ulp, allowed {:.3g}", *f.off, *f.allowed);
  if (!f.reading.empty()) text += "; another reading of the paper, " + f.reading;
  return text;
}

class Runs {
 public:
  Runs(const RunPlan& plan, Verdict& verdict) : plan_(plan), verdict_(verdict), whole_(row("whole")) {}

  void ask() {
    std::uint64_t number = plan_.first;
    for (std::uint64_t asked = 0; asked < plan_.scenes && failures_ < kMostFailures; ++number) {
      if (plan_.stops()) break;
      const auto scene = random_scene(plan_.features, plan_.seed, number);
      if (!scene) continue;
      ++asked;
      plan_.progress(fmt::format("scene {} of seed {}", number, plan_.seed));
      ask(*scene, number);
    }
    if (failures_ == kMostFailures)
      verdict_.notes["runs"] = "given up after 5 failures; further scenes were not asked";
    verdict_.rows.push_back(whole_);
    for (auto& [feature, row] : by_feature_) verdict_.rows.push_back(std::move(row));
  }

 private:
  static Row row(const std::string& feature) { return {kArea, "run." + feature, "runs", feature, kPage}; }

  Example example(std::uint64_t number, std::string why) const {
    const std::string features =
        plan_.features.empty() ? "" : fmt::format(" --features {}", fmt::join(plan_.features, ","));
    Example made{
        Class::right,
        fmt::format("scene {} of seed {}", number, plan_.seed),
        std::move(why),
        {fmt::format("tps scene random --seed {} --number {}{} -o scene.json", plan_.seed, number, features)},
        {},
        0,
        0};
    if (!plan_.source.command_for_scene.empty()) {
      made.commands.push_back(plan_.source.command_for_scene + " | tps check --scene scene.json -");
    }
    return made;
  }

  void ask(const Scene& scene, std::uint64_t number) {
    const Run found = plan_.source.run(scene);
    if (found.kind == Run::Kind::failed && !is_wrong_before_its_end(scene, found.trace)) {
      ++failures_;
      return verdict_.note_failure(fmt::format("scene {} of seed {}", number, plan_.seed), found.problem);
    }
    if (found.kind == Run::Kind::refused)
      return whole_.add({Class::refused, found.problem},
                        example(number, "refuses the scene: " + found.problem));
    judge(scene, number, found.trace);
  }

  static check::CheckReport checked(const Scene& scene, const std::string& trace) {
    const runs::ScratchFile file(trace), scene_file(write_scene(scene));
    check::CheckOptions options;
    options.scene = scene_file.path();
    options.max_reports = 10 * kMostEventsOfARun;  // of each rule: all
    return check::check_trace(file.path(), options);
  }

  /// A run that goes on for ever may have gone wrong: what it wrote before says so.
  static bool is_wrong_before_its_end(const Scene& scene, const std::string& trace) {
    try {
      const check::CheckReport report = checked(scene, trace);
      return std::any_of(report.findings.begin(), report.findings.end(), [](const check::Finding& finding) {
        return finding.rule != check::Rule::end && finding.rule != check::Rule::progress &&
               class_of(finding) == Class::wrong;
      });
    } catch (const InputError&) {
      return false;
    }
  }

  void judge(const Scene& scene, std::uint64_t number, const std::string& trace) {
    check::CheckReport report;
    try {
      report = checked(scene, trace);
    } catch (const InputError& error) {
      const std::string why = error.problems().empty() ? "no trace" : error.problems().front().message;
      return whole_.add({Class::wrong, why}, example(number, "wrote no trace that can be judged: " + why));
    }
    const auto features = features_by_line(trace, scene);
    std::map<std::uint64_t, const check::Finding*> worst;
    const check::Finding* worst_of_all = nullptr;
    for (const check::Finding& finding : report.findings) {
      const check::Finding*& here = worst[finding.line];
      if (here == nullptr || class_of(finding) > class_of(*here)) here = &finding;
      if (worst_of_all == nullptr || class_of(finding) > class_of(*worst_of_all)) worst_of_all = &finding;
    }
    add(whole_, report.conforming() && !report.inconclusive() ? nullptr : worst_of_all, number);
    for (const auto& [line, met] : features) {
      const auto finding = worst.find(line);
      for (const std::string& feature : met) {
        Row& events = by_feature_.try_emplace(feature, row(feature)).first->second;
        add(events, finding == worst.end() ? nullptr : finding->second, number);
      }
    }
  }

  void add(Row& row, const check::Finding* finding, std::uint64_t number) const {
    if (finding == nullptr) return row.add({}, {});
    row.add({class_of(*finding), words_of(*finding)}, example(number, words_of(*finding)));
    if (!finding->reading.empty()) ++row.hypotheses[finding->reading];
  }

  const RunPlan& plan_;
  Verdict& verdict_;
  Row whole_;
  std::map<std::string, Row> by_feature_;
  int failures_ = 0;
};

}  // namespace

void ask_runs(const RunPlan& plan, Verdict& verdict) {
  Runs(plan, verdict).ask();
}

}  // namespace tps::properties::conform
