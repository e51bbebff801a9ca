#include "verify/trace_check/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "reference/run/run.hpp"
#include "reference/scene/read_scene.hpp"
#include "verify/trace_check/judge_lines.hpp"
#include "verify/trace_check/parallel_judge.hpp"
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
  report.lines = 1;
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

constexpr const char* kPromisesExactTimes =
    "the header promises certified timing, so that times are held to exact ones and ties to their order; who "
    "writes t rounded once leaves \"options\" out of the header";

bool breaks_the_promise_of_times(const TraceFacts& facts, const CheckReport& report) {
  return facts.minimal && facts.timing == Timing::certified &&
         std::ranges::any_of(report.findings, [](const Finding& finding) {
           return finding.outcome == Outcome::violated &&
                  (finding.rule == Rule::contact || finding.rule == Rule::earliest);
         });
}

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
    tally.demand(Rule::schema, !head.has_another_scene, [&](Finding& f) {
      f.message = fmt::format("the scene of the trace is not that of {}", options.scene);
    });
  }
  if (head.minimal) say_what_minimal_leaves_out(tally, head);
}

/// One way to take a trace, and what comes of it.
struct Way {
  Way(const TraceFacts& facts, const CheckReport& begun, std::uint64_t max_reports)
      : parts{facts, begun, max_reports}, all(begun, max_reports) {}

  JudgeParts parts;
  Judged all;
};

MakeJudge maker_of_judges(const JudgeParts& parts, const std::string& scalar) {
  return [&parts, scalar](std::string_view state, std::uint64_t number) {
    if (scalar == "float" || scalar == "double")
      return judge_of_doubles(parts, scalar == "float", state, number);
    return judge_of_wide(parts, scalar, state, number);
  };
}

/// Reads and judges line by line.
void judge_in_turn(TraceInput& input, Borders borders, const std::vector<std::unique_ptr<Way>>& ways,
                   const std::function<void(std::uint64_t events)>& progress) {
  constexpr std::uint64_t kLinesBetweenReports = 4096;
  std::vector<std::unique_ptr<LineJudge>> judges;
  for (const auto& way : ways) judges.push_back(maker_of_judges(way->parts, way->all.report.scalar)("", 0));
  LineText line;
  while (input.next(line)) {
    const bool is_at_border = borders.is_at(line);
    for (std::size_t n = 0; n < ways.size(); ++n) {
      judges[n]->judge(line, input.lines());
      const std::unique_ptr<Judged> ended = is_at_border ? judges[n]->end_segment() : nullptr;
      if (ended) ways[n]->all.take_over(*ended);
    }
    if (progress && input.lines() % kLinesBetweenReports == 0) progress(ways.front()->all.report.events);
  }
  for (std::size_t n = 0; n < ways.size(); ++n) {
    ways[n]->all.report.lines = input.lines();
    ways[n]->all.take_over(*judges[n]->close(input.lines()));
  }
}

}  // namespace

CheckReport check_trace(const std::string& path, const CheckOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  const auto stop = [&] { return options.interrupt != nullptr && options.interrupt->load(); };
  TraceInput input(path, options.scene, stop);
  const TraceFileHead& head = input.head();

  const CheckReport begun = start_report(path, head, options.tolerance);
  const TraceFacts facts{.scene = head.scene,
                         .timing = head.timing,
                         .minimal = head.minimal,
                         .semantics = head.semantics,
                         .eager = head.positions == "eager",
                         .own_draws = head.own_draws && !options.trust_draws};
  std::vector<std::unique_ptr<Way>> ways;
  ways.push_back(std::make_unique<Way>(facts, begun, options.max_reports));
  if (head.minimal && head.positions.empty()) {
    ways.push_back(std::make_unique<Way>(facts, begun, options.max_reports));
    ways.back()->parts.facts.eager = true;
  }
  for (const auto& way : ways) judge_header(way->all.tally, head, options);

  const auto progress = [&](std::uint64_t events) {
    if (options.progress) options.progress({input.bytes(), events});
  };
  const Borders borders(!facts.minimal && !facts.eager, options.segment_lines);
  const unsigned jobs = options.jobs != 0 ? options.jobs : std::max(1U, std::thread::hardware_concurrency());
  if (jobs == 1 || facts.minimal || facts.eager) {
    judge_in_turn(input, borders, ways, progress);
  } else {
    Segments segments(input, borders, options.segment_bytes);
    judge_in_parallel(segments, maker_of_judges(ways.front()->parts, head.scalar), {jobs, stop, progress},
                      ways.front()->all);
  }
  for (const auto& way : ways) way->all.close(way->parts.facts);
  CheckReport& report = ways.front()->all.report;
  if (ways.size() > 1 && explains_more(report, ways.back()->all.report)) {
    report = std::move(ways.back()->all.report);
    report.notes.emplace_back(kTakenAsEager);
  }
  if (breaks_the_promise_of_times(facts, report)) report.notes.emplace_back(kPromisesExactTimes);
  report.interrupted = input.interrupted() || stop();
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return std::move(report);
}

}  // namespace tps::check
