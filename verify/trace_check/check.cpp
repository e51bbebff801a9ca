#include "verify/trace_check/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "reference/run/run.hpp"
#include "reference/scene/read_scene.hpp"
#include "verify/trace_check/judge_lines.hpp"
#include "verify/trace_check/trace_input.hpp"

namespace tps::check {
namespace {

CheckReport start_report(const std::string& path, const TraceFileHead& head, double tolerance) {
  CheckReport report;
  report.file = path == "-" ? "standard input" : path;
  report.title = head.scene.title;
  report.scalar = head.scalar;
  report.timing = timing_names()[static_cast<std::size_t>(head.timing)];
  report.minimal = head.minimal;
  report.particles = head.scene.particles.size();
  report.tolerance = tolerance;
  for (const RuleFacts& facts : kRuleFacts)
    report.rules[static_cast<std::size_t>(facts.rule)].rule = facts.rule;
  return report;
}

void say_what_minimal_leaves_out(Tally& tally, const TraceFileHead& head) {
  tally.not_judged(Rule::flight, "positions are judged where the trace has them");
  tally.not_judged(Rule::bystanders, "the trace has no velocities before events");
  tally.not_judged(Rule::states, "a minimal trace has no full states to judge");
  if (head.scene.grouping) tally.not_judged(Rule::groups, "stored impulses are the check's own");
}

constexpr const char* kTakenAsEager =
    "positions are taken to be advanced and rounded for everybody at every event; \"positions\":\"eager\" in "
    "the "
    "header says so";

/// A trace that does not say how its positions are kept is judged both ways. @return whether the second is
/// the better one: nothing is violated then.
bool explains_more(const CheckReport& strict, const CheckReport& eager) {
  return strict.violated() > 0 && eager.violated() == 0;
}

void judge_header(Tally& tally, const TraceFileHead& head, const CheckOptions& options) {
  tally.step.line = 1;
  tally.demand(Rule::schema, head.checksum_holds, [](Finding& f) {
    f.message =
        "/checksum is not that of scalar, options and scene: the line was damaged or edited (if it was "
        "edited, leave the checksum out)";
  });
  if (!options.scene.empty()) {
    tally.demand(Rule::schema, head.scene == read_scene_file(options.scene), [&](Finding& f) {
      f.message = fmt::format("the scene of the trace is not that of {}", options.scene);
    });
  }
  if (head.minimal) say_what_minimal_leaves_out(tally, head);
}

}  // namespace

CheckReport check_trace(const std::string& path, const CheckOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  const auto stop = [&] { return options.interrupt != nullptr && options.interrupt->load(); };
  TraceInput input(path, options.scene, stop);
  const TraceFileHead& head = input.head();

  CheckReport report = start_report(path, head, options.tolerance);
  report.lines = 1;
  CheckReport eager_report = report;
  Tally tally(report, options.tolerance, options.max_reports);
  Tally eager_tally(eager_report, options.tolerance, options.max_reports);
  const TraceFacts facts{.scene = head.scene,
                         .timing = head.timing,
                         .minimal = head.minimal,
                         .semantics = head.semantics,
                         .eager = head.positions == "eager",
                         .own_draws = head.own_draws && !options.trust_draws};
  std::vector<Judgement> ways = {{facts, tally, report}};
  if (head.minimal && head.positions.empty()) {
    ways.push_back({facts, eager_tally, eager_report});
    ways.back().facts.eager = true;
  }
  for (const Judgement& way : ways) judge_header(way.tally, head, options);

  LineSource source{[&](LineSource::Text& line) {
    const bool more = input.next(line);
    report.lines = input.lines();
    constexpr std::uint64_t kLinesBetweenReports = 4096;
    if (more && options.progress && report.lines % kLinesBetweenReports == 0)
      options.progress({input.bytes(), report.events});
    return more;
  }};
  if (head.scalar == "float") {
    judge_lines<double>(source, ways, {0x1p-24L, 0x1p-149L, 24, true});
  } else if (head.scalar == "double") {
    judge_lines<double>(source, ways, {0x1p-53L, 0x1p-1074L, 53, false});
  } else {
    judge_wide_lines(source, ways, head.scalar);
  }
  for (const Judgement& way : ways) way.tally.close_sums();
  if (ways.size() > 1 && explains_more(report, eager_report)) {
    eager_report.lines = report.lines;
    report = std::move(eager_report);
    report.notes.emplace_back(kTakenAsEager);
  }
  report.interrupted = input.interrupted();
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return report;
}

}  // namespace tps::check
