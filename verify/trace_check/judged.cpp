#include "verify/trace_check/judged.hpp"

#include <fmt/format.h>

namespace tps::check {

void Judged::take_over(const Judged& later) {
  begins_with_state = begins_with_state || (report.events == 0 && later.begins_with_state);
  if (later.report.states > 0) last_state = report.events + later.last_state;
  has_draws = has_draws || later.has_draws;
  digits.take_over(later.digits);
  below_rounding.take_over(later.below_rounding);
  report.certified_comparisons += later.report.certified_comparisons;
  tally.take_over(later.tally);
}

void Judged::close(const TraceFacts& facts) {
  if (const std::optional<std::string> note = below_rounding.note()) tally.note(*note);
  if (!facts.minimal) say_missing_states();
  if (report.end == "out_of_range")
    tally.not_judged(Rule::end, "that the step after the last event leaves the range is taken as given");
  if (!facts.own_draws && has_draws)
    tally.not_judged(Rule::tethers, "the draws are taken as given, only their use is judged");
  if (report.violated() > 0) {
    if (const auto advice = digits.advice()) tally.note(*advice);
  }
  tally.close_sums();
}

void Judged::say_missing_states() {
  if (report.states == 0) {
    tally.not_judged(Rule::states, "the trace has no full states to judge");
    return;
  }
  if (!begins_with_state) tally.not_judged(Rule::states, "there is no full state before the first event");
  if (last_state != report.events)
    tally.not_judged(Rule::states,
                     fmt::format("there is no full state behind event {}, the last", report.events));
}

}  // namespace tps::check
