// Ends that are not those of the run.
#include "tests/trace_check/edits.hpp"

namespace tps::mutation {
namespace {

Broken nothing_more_claimed(Trace& trace, std::uint64_t) {
  if (trace.lines.back().at("end") != "max_events") return {};
  return end_for(trace, "no_more_events");
}

Broken end_missing(Trace& trace, std::uint64_t) {
  const std::uint64_t k = number_of_last(trace);
  trace.lines.pop_back();
  return k;
}

Broken end_torn(Trace& trace, std::uint64_t) {
  trace.torn = 9;
  return number_of_last(trace);
}

Broken end_miscounts(Trace& trace, std::uint64_t) {
  const std::uint64_t k = number_of_last(trace);
  trace.lines.change_last()["events"] = k + 1;
  return k;
}

Broken end_misdated(Trace& trace, std::uint64_t) {
  const std::vector<std::size_t> events = event_lines(trace);
  const double last = since_start(trace, trace.lines[events.back()].at("t"));
  if (last == 0) return {};
  trace.lines.change_last()["t"] = clock_time(trace, last / 2);
  return number_of_last(trace);
}

Broken event_behind_the_end(Trace& trace, std::uint64_t) {
  const std::vector<std::size_t> events = event_lines(trace);
  if (events.empty()) return {};
  const std::uint64_t k = number_of_last(trace);
  trace.lines.push_back(trace.lines[events.back()]);
  trace.lines.change_last()["k"] = k + 1;
  trace.lines.change_last()["dt"] = "0x0p+0";
  return k;
}

Broken ended_twice(Trace& trace, std::uint64_t) {
  trace.lines.push_back(trace.lines.back());
  return number_of_last(trace);
}

/// An event later than the run lasts.
Broken event_behind_the_duration(Trace& trace, std::uint64_t) {
  const std::vector<std::size_t> events = event_lines(trace);
  if (events.empty() || trace.lines.back().at("end") != "duration") return {};
  Retold before(trace);
  for (std::size_t n = 0; n < events.back(); ++n) before.hear(trace.lines[n], n);
  if (!trace.lines[events.back()].contains("pre")) return {};
  carry_event(trace, events.back(), before, trace.scene.duration * 1.5);
  return number_of(trace, events.back());
}

}  // namespace

const std::vector<Mutation>& broken_ends() {
  using enum check::Rule;
  static const std::vector<Mutation> list = {
      {"nothing_more_claimed", "the run ends because nothing can happen, and something can", earliest,
       nothing_more_claimed},
      {"end_missing", "the last line is missing", end, end_missing},
      {"end_torn", "the last line is torn", end, end_torn},
      {"end_miscounts", "the last line counts one event more", end, end_miscounts},
      {"end_misdated", "the last line has a time before the last event", end, end_misdated},
      {"event_behind_the_end", "an event behind the last line", end, event_behind_the_end},
      {"ended_twice", "the last line comes twice", end, ended_twice},
      {"event_behind_the_duration", "an event later than the run lasts", end, event_behind_the_duration},
  };
  return list;
}

std::vector<Mutation> mutations() {
  std::vector<Mutation> all;
  for (const auto* list : {&broken_lines(), &broken_times(), &broken_sequences(), &broken_impulses(),
                           &broken_velocities(), &broken_tethers(), &broken_groups(), &broken_loads(),
                           &broken_plans(), &broken_states(), &broken_ends(), &broken_standstills()}) {
    all.insert(all.end(), list->begin(), list->end());
  }
  return all;
}

}  // namespace tps::mutation
