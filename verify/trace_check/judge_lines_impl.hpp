// judge_lines, included by the instantiating sources only.
#pragma once

#include "verify/trace_check/checker_end_impl.hpp"
#include "verify/trace_check/checker_follow_impl.hpp"
#include "verify/trace_check/checker_impl.hpp"
#include "verify/trace_check/checker_meet_impl.hpp"
#include "verify/trace_check/decimal_digits.hpp"
#include "verify/trace_check/judge_lines.hpp"
#include "verify/trace_check/read_line.hpp"

namespace tps::check {

template <typename Number>
class LineJudge {
 public:
  LineJudge(const TraceFacts& facts, const Precision<Number>& precision, Tally& tally, CheckReport& report)
      : facts_(facts),
        tally_(tally),
        report_(report),
        reading_(facts.scene, facts.minimal, precision.digits),
        checker_(facts, precision, tally) {}

  void judge(const LineSource::Text& line) {
    tally_.step = {report_.lines, 0, {}, {}};
    if (line.too_long) {
      std::string beginning(line.text);
      for (char& c : beginning) c = c >= ' ' && c <= '~' ? c : '?';
      bad("", fmt::format("is longer than any line of this trace can be: \"{}…\"", beginning));
      return;
    }
    try {
      Line<Number> read = reading_.read(line.text);
      tally_.pass(Rule::schema);
      std::visit([this](const auto& parsed) { this->take(parsed); }, read);
    } catch (const LineProblem& problem) {
      bad(problem.pointer, problem.what());
    }
  }

  void close() {
    tally_.step = {report_.lines, checker_.model().events, {}, {}};
    checker_.close();
    report_.certified_comparisons = checker_.exact_comparisons();
    if (!facts_.minimal) say_missing_states();
    if (report_.end == "out_of_range")
      tally_.not_judged(Rule::end, "that the step after the last event leaves the range is taken as given");
    if (!facts_.own_draws && has_draws_)
      tally_.not_judged(Rule::tethers, "the draws are taken as given, only their use is judged");
    if (report_.violated() == 0) return;
    if (const auto advice = digits_.advice()) report_.notes.push_back(*advice);
  }

 private:
  void say_missing_states() {
    if (report_.states == 0) {
      tally_.not_judged(Rule::states, "the trace has no full states to judge");
      return;
    }
    if (!begins_with_state_) tally_.not_judged(Rule::states, "there is no full state before the first event");
    if (last_state_ != report_.events)
      tally_.not_judged(Rule::states,
                        fmt::format("there is no full state behind event {}, the last", report_.events));
  }

  void bad(const std::string& pointer, const std::string& message) {
    tally_.demand(Rule::schema, false, [&](Finding& f) {
      f.message = pointer.empty() ? message : fmt::format("{} {}", pointer, message);
    });
  }

  void take(const EventLine<Number>& event) {
    ++report_.events;
    tally_.step.event = event.k.value_or(checker_.model().events + 1);
    tally_.step.t = event.t_text;
    for (const int n : {event.i, event.j}) {
      if (n >= 0) tally_.step.particles.push_back(checker_.model().id(n));
    }
    has_draws_ = has_draws_ || event.draw.has_value();
    digits_.add(DecimalDigits::times, rough(event.t).hi + facts_.scene.start_time);
    for (const InvolvedParticle<Number>& p : event.involved) {
      for (std::size_t k = 0; k < 3; ++k) {
        digits_.add(DecimalDigits::velocities, static_cast<double>(p.velocity_after[k]));
        if (p.position_after)
          digits_.add(DecimalDigits::positions, static_cast<double>((*p.position_after)[k]));
      }
    }
    checker_.take(event);
  }
  void take(const StateLine<Number>& state) {
    ++report_.states;
    begins_with_state_ = begins_with_state_ || report_.events == 0;
    last_state_ = report_.events;
    tally_.step.event = state.data.k;
    checker_.take(state);
  }
  void take(const EndLine<Number>& end) {
    report_.end = end.reason;
    tally_.step.event = end.events;
    checker_.take(end);
  }

  const TraceFacts facts_;
  bool has_draws_ = false;
  bool begins_with_state_ = false;
  std::uint64_t last_state_ = 0;  ///< behind which event, counted in lines
  DecimalDigits digits_;
  Tally& tally_;
  CheckReport& report_;
  LineReading<Number> reading_;
  Checker<Number> checker_;
};

template <typename Number>
void judge_lines(LineSource& source, const std::vector<Judgement>& ways, const Precision<Number>& precision) {
  std::vector<std::unique_ptr<LineJudge<Number>>> judges;
  for (const Judgement& way : ways)
    judges.push_back(std::make_unique<LineJudge<Number>>(way.facts, precision, way.tally, way.report));
  LineSource::Text line;
  while (source.next(line)) {
    for (std::size_t n = 0; n < ways.size(); ++n) {
      ways[n].report.lines = ways.front().report.lines;
      judges[n]->judge(line);
    }
  }
  for (const auto& judge : judges) judge->close();
}

}  // namespace tps::check
