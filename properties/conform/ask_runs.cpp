#include "properties/conform/ask_runs.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>

#include "properties/conform/feature_hint.hpp"
#include "properties/conform/judge_trace.hpp"
#include "properties/conform/random_scene.hpp"
#include "properties/conform/trace_features.hpp"
#include "reference/text/input_error.hpp"

namespace tps::properties::conform {
namespace {

constexpr const char* kPage = "docs/check.md";
constexpr const char* kArea = "whole runs";
constexpr int kMostFailures = 5;

class Runs {
 public:
  Runs(const RunPlan& plan, Verdict& verdict)
      : plan_(plan), verdict_(verdict), whole_(row("whole")), hint_(plan.features) {}

  void ask() {
    std::uint64_t number = plan_.first;
    for (std::uint64_t asked = 0;
         asked < plan_.scenes && failures_ < kMostFailures && endless_ < kMostFailures; ++number) {
      if (plan_.stops()) break;
      const auto scene = random_scene(plan_.features, plan_.seed, number);
      if (!scene) continue;
      ++asked;
      plan_.progress(fmt::format("scene {} of seed {}", number, plan_.seed));
      ask(*scene, number);
    }
    if (failures_ == kMostFailures || endless_ == kMostFailures) {
      verdict_.notes["runs"] =
          fmt::format("given up after {} {}; further scenes were not asked", kMostFailures,
                      failures_ == kMostFailures ? "failures" : "runs without an end");
    }
    if (const auto words = hint_.words()) verdict_.notes["hint"] = *words;
    if (std::none_of(plan_.features.begin(), plan_.features.end(), calls_for_effect)) {
      verdict_.notes["effects of the outlook"] = fmt::format(
          "not asked; --features {} asks for those that the simulator has", fmt::join(effect_words(), ","));
    }
    verdict_.rows.push_back(whole_);
    for (auto& [feature, row] : by_feature_) verdict_.rows.push_back(std::move(row));
  }

 private:
  static Row row(const std::string& feature) { return {kArea, "run." + feature, "runs", feature, kPage}; }

  Example example(const Scene& scene, std::uint64_t number, std::string why) const {
    const std::string features =
        plan_.features.empty() ? "" : fmt::format(" --features {}", fmt::join(plan_.features, ","));
    Example made{
        Class::right,
        fmt::format("scene {} of seed {}", number, plan_.seed),
        std::move(why),
        {fmt::format("tps scene random --seed {} --number {}{} -o scene.json", plan_.seed, number, features)},
        fmt::format("{{\"scene\":{}}}", text_of_random(scene, SceneStyle::compact))};
    const std::string again = plan_.source.command_for_scene(scene);
    if (!again.empty()) made.commands.push_back(again);
    return made;
  }

  void ask(const Scene& scene, std::uint64_t number) {
    const Run found = plan_.source.run(scene);
    switch (found.kind) {
      case Run::Kind::traced:
        return judge(scene, number, found.trace);
      case Run::Kind::refused:
        return add_whole({Class::refused, found.problem}, scene, number,
                         "refuses the scene: " + found.problem);
      case Run::Kind::no_trace:
        return add_whole({Class::wrong, found.problem}, scene, number, found.problem);
      case Run::Kind::endless:
      case Run::Kind::failed:
        break;
    }
    const Beginning beginning = judged_beginning(scene, found.trace);
    // A run that goes on for ever may have gone wrong: what it wrote before says so.
    if (found.kind == Run::Kind::endless && beginning.is_wrong) {
      ++endless_;
      return judge(scene, number, found.trace, "; the run did not end: " + found.problem);
    }
    ++failures_;
    hint_.add(scene, true);
    const Example shown = example(scene, number, found.problem + "; " + beginning.words);
    verdict_.note_failure({shown.id, shown.why, shown.commands});
  }

  void add_whole(const Grade& grade, const Scene& scene, std::uint64_t number, const std::string& why) {
    whole_.add(grade, [&] { return example(scene, number, why); });
    hint_.add(scene, verdict_.profile.fails[index_of(grade.which)]);
  }

  /// The line behind which a run is not judged: where a wall has joined a group, other particles part at
  /// other times than those that the check follows.
  std::uint64_t end_of_what_is_judged(const check::CheckReport& report) const {
    std::uint64_t end = std::numeric_limits<std::uint64_t>::max();
    for (const check::Finding& finding : report.findings) {
      if (finding.reading.starts_with("D9:")) end = std::min<std::uint64_t>(end, finding.line);
    }
    if (end != std::numeric_limits<std::uint64_t>::max())
      verdict_.notes["a wall joins a group (D9)"] = "such runs were judged up to there";
    return end;
  }

  /// What the energy of an event becomes follows from its impulse.
  static bool follows_from_a_reading(const check::Finding& finding, const check::CheckReport& report) {
    return finding.rule == check::Rule::conservation &&
           std::any_of(report.findings.begin(), report.findings.end(), [&](const check::Finding& other) {
             return other.line == finding.line && other.rule == check::Rule::impulse &&
                    class_of(other) == Class::other_reading;
           });
  }

  void judge(const Scene& scene, std::uint64_t number, const std::string& trace,
             const std::string& besides = {}) {
    check::CheckReport report;
    try {
      report = checked_run(scene, trace, plan_.source.most_events);
    } catch (const InputError& error) {
      const std::string why = error.problems().empty() ? "no trace" : error.problems().front().message;
      return add_whole({Class::wrong, why}, scene, number, "wrote no trace that can be judged: " + why);
    }
    for (const check::Rule rule : {check::Rule::tethers, check::Rule::earliest}) {
      const std::string& why = report.rules[static_cast<std::size_t>(rule)].not_judged;
      if (!why.empty()) verdict_.notes[fmt::format("not judged, {}", check::name(rule))] = why;
    }
    const auto features = features_by_line(trace, scene);
    const std::uint64_t end = end_of_what_is_judged(report);
    std::map<std::uint64_t, const check::Finding*> worst;
    const check::Finding* worst_of_all = nullptr;
    for (const check::Finding& finding : report.findings) {
      if (finding.line > end || follows_from_a_reading(finding, report)) continue;
      const check::Finding*& here = worst[finding.line];
      if (here == nullptr || class_of(finding) > class_of(*here)) here = &finding;
      if (worst_of_all == nullptr || class_of(finding) > class_of(*worst_of_all)) worst_of_all = &finding;
    }
    if (report.conforming() && !report.inconclusive()) worst_of_all = nullptr;
    add(whole_, worst_of_all, scene, number, besides);
    hint_.add(scene, worst_of_all != nullptr && verdict_.profile.fails[index_of(class_of(*worst_of_all))]);
    for (const auto& [line, met] : features) {
      if (line > end) break;
      const auto finding = worst.find(line);
      for (const std::string& feature : met) {
        Row& events = by_feature_.try_emplace(feature, row(feature)).first->second;
        add(events, finding == worst.end() ? nullptr : finding->second, scene, number);
      }
    }
  }

  void add(Row& row, const check::Finding* finding, const Scene& scene, std::uint64_t number,
           const std::string& besides = {}) const {
    if (finding == nullptr) return row.add({}, {});
    row.add({class_of(*finding), words_of(*finding)}, [&] {
      Example shown = example(scene, number, words_of(*finding) + besides);
      if (!finding->particles.empty())  // those who are drawn
        shown.found =
            fmt::format("{{\"i\":{},\"j\":{}}}", finding->particles.front(), finding->particles.back());
      return shown;
    });
    if (!finding->reading.empty()) ++row.hypotheses[finding->reading];
  }

  const RunPlan& plan_;
  Verdict& verdict_;
  Row whole_;
  std::map<std::string, Row> by_feature_;
  FeatureHint hint_;
  int failures_ = 0;
  int endless_ = 0;  ///< runs that went wrong and did not end: each costs its whole time limit
};

}  // namespace

void ask_runs(const RunPlan& plan, Verdict& verdict) {
  Runs(plan, verdict).ask();
}

}  // namespace tps::properties::conform
