// LineJudge of a scalar, included by the instantiating sources only.
#pragma once

#include "verify/trace_check/checker_end_impl.hpp"
#include "verify/trace_check/checker_follow_impl.hpp"
#include "verify/trace_check/checker_impl.hpp"
#include "verify/trace_check/checker_meet_impl.hpp"
#include "verify/trace_check/checker_segment_impl.hpp"
#include "verify/trace_check/judge_lines.hpp"
#include "verify/trace_check/read_line.hpp"

namespace tps::check {

template <typename Number>
class LineJudgeOf : public LineJudge {
 public:
  LineJudgeOf(const JudgeParts& parts, const Precision<Number>& precision)
      : parts_(parts),
        precision_(precision),
        judged_(fresh()),
        reading_(parts.facts.scene, parts.facts.minimal, precision.digits) {}

  void begin() { checker_.emplace(parts_.facts, precision_, judged_->tally); }
  /// @return whether there is such a state in the line, of no more events than lines before it
  bool begin_at(std::string_view text, std::uint64_t number) {
    try {
      const Line<Number>& line = reading_.read(text);
      const auto* state = std::get_if<StateLine<Number>>(&line);
      if (state == nullptr || state->data.k > number) return false;
      take_up({state->data, nullptr});
      return true;
    } catch (const std::exception&) {
      return false;  // who comes to the line says why
    }
  }

  void judge(const LineText& line, std::uint64_t number) override {
    state_.reset();
    tally().step.begin(number);
    if (line.too_long) {
      std::string beginning(line.text);
      for (char& c : beginning) c = c >= ' ' && c <= '~' ? c : '?';
      bad("", fmt::format("is longer than any line of this trace can be: \"{}…\"", beginning));
      return;
    }
    try {
      Line<Number>& read = reading_.read(line.text);
      tally().pass(Rule::schema);
      std::visit([this](auto& parsed) { this->take(parsed); }, read);
    } catch (const EndProblem& problem) {
      bad(problem.pointer, problem.what());
      checker_->note_unreadable_end();
    } catch (const LineProblem& problem) {
      bad(problem.pointer, problem.what());
    }
  }

  std::unique_ptr<Judged> end_segment() override {
    if (!state_ || !checker_->ends_segment()) return nullptr;
    const Waits<Number> waits = checker_->waits();
    std::unique_ptr<Judged> ended = finished();
    judged_ = fresh();
    take_up({state_->data, &waits});
    return ended;
  }

  bool needed_before() const override { return checker_->needed_before(); }

  std::unique_ptr<Judged> close(std::uint64_t lines) override {
    tally().step.begin(lines, checker_->model().events);
    checker_->close();
    return finished();
  }

 private:
  std::unique_ptr<Judged> fresh() const { return std::make_unique<Judged>(parts_.begun, parts_.max_reports); }
  void take_up(const TakenUp<Number>& from) {
    checker_.reset();
    checker_.emplace(parts_.facts, precision_, judged_->tally, from);
  }
  std::unique_ptr<Judged> finished() {
    judged_->report.certified_comparisons = checker_->exact_comparisons();
    judged_->below_rounding = checker_->below_rounding();
    judged_->report.segments = 1;
    return std::move(judged_);
  }
  Tally& tally() { return judged_->tally; }

  void bad(const std::string& pointer, const std::string& message) {
    tally().demand(Rule::schema, false, [&](Finding& f) {
      f.message = pointer.empty() ? message : fmt::format("{} {}", pointer, message);
    });
  }

  void take(const EventLine<Number>& event) {
    ++judged_->report.events;
    tally().step.event = event.k.value_or(checker_->model().events + 1);
    tally().step.t = event.t_text;
    for (const int n : {event.i, event.j}) {
      if (n >= 0) tally().step.particles.push_back(checker_->model().id(n));
    }
    judged_->has_draws = judged_->has_draws || event.draw.has_value();
    if (!judged_->digits.has_enough()) add_digits(event);
    checker_->take(event);
  }
  void add_digits(const EventLine<Number>& event) {
    DecimalDigits& digits = judged_->digits;
    const Scene& scene = parts_.facts.scene;
    digits.add(DecimalDigits::times, rough(event.t).hi + (scene.drag ? 0 : scene.start_time));
    for (const InvolvedParticle<Number>& p : event.involved) {
      for (std::size_t k = 0; k < 3; ++k) {
        digits.add(DecimalDigits::velocities, static_cast<double>(p.velocity_after[k]));
        if (p.position_after)
          digits.add(DecimalDigits::positions, static_cast<double>((*p.position_after)[k]));
      }
    }
  }
  void take(StateLine<Number>& state) {
    CheckReport& report = judged_->report;
    ++report.states;
    judged_->begins_with_state = judged_->begins_with_state || report.events == 0;
    judged_->last_state = report.events;
    tally().step.event = state.data.k;
    checker_->take(state);
    state_ = std::move(state);
  }
  void take(const EndLine<Number>& end) {
    judged_->report.end = end.reason;
    tally().step.event = end.events;
    checker_->take(end);
  }

  const JudgeParts& parts_;
  const Precision<Number> precision_;
  std::unique_ptr<Judged> judged_;  ///< of the segment so far
  LineReading<Number> reading_;
  std::optional<Checker<Number>> checker_;
  std::optional<StateLine<Number>> state_;  ///< the line judged last, if it is one
};

template <typename Number>
std::unique_ptr<LineJudge> line_judge(const JudgeParts& parts, const Precision<Number>& precision,
                                      std::string_view state, std::uint64_t number) {
  auto judge = std::make_unique<LineJudgeOf<Number>>(parts, precision);
  if (state.empty()) {
    judge->begin();
  } else if (!judge->begin_at(state, number)) {
    return nullptr;
  }
  return judge;
}

}  // namespace tps::check
