// Ends that are not those of the run, and runs that stand still.
#include "tests/trace_check/edits.hpp"

namespace tps::mutation {
namespace {

std::uint64_t behind_all(const Trace& trace) {
  return trace.lines.back().at("events").get<std::uint64_t>();
}

/// Gives the end another reason where the run has one of the others.
template <typename Condition>
Broken reason_given(Trace& trace, const char* reason, Condition condition) {
  Json& end = trace.lines.back();
  if (end.at("end") == reason || !condition(end)) return {};
  end["end"] = reason;
  return behind_all(trace);
}

Broken nothing_more_claimed(Trace& trace, std::uint64_t) {
  return reason_given(trace, "no_more_events", [&](const Json& end) {
    return end.at("end") == "max_events" || (end.at("end") == "duration" && trace.scene.duration < 1e300);
  });
}

Broken duration_claimed(Trace& trace, std::uint64_t) {
  return reason_given(trace, "duration", [](const Json& end) { return end.at("end") == "max_events"; });
}

Broken stall_claimed(Trace& trace, std::uint64_t) {
  return reason_given(trace, "stalled", [](const Json& end) { return end.at("end") != "stalled"; });
}

Broken stall_denied(Trace& trace, std::uint64_t) {
  return reason_given(trace, "max_events", [](const Json& end) { return end.at("end") == "stalled"; });
}

/// A stalled run goes on as if nothing were the matter.
Broken stall_passed_over(Trace& trace, std::uint64_t) {
  if (trace.lines.back().at("end") != "stalled") return {};
  const std::uint64_t k = behind_all(trace) + 1;
  const std::vector<std::size_t> events = event_lines(trace);
  const std::size_t behind = events.back() + 1;
  constexpr std::size_t kMore = 4;  // two anchors pull in turn
  for (std::size_t n = 0; n < kMore; ++n) {
    insert_line(trace, behind + n, Json(trace.lines[events[events.size() - kMore + n]]));
  }
  trace.lines.back()["end"] = "max_events";
  settle(trace);
  return k;
}

Broken progress_misdated(Trace& trace, std::uint64_t) {
  Json& state = trace.lines[*last_state(trace)];
  if (state.at("state") == 0) return {};
  state["progress_event"] = state.at("progress_event").get<std::uint64_t>() + 1;
  return state.at("state").get<std::uint64_t>();
}

Broken end_missing(Trace& trace, std::uint64_t) {
  const std::uint64_t k = behind_all(trace);
  trace.lines.pop_back();
  return k;
}

Broken end_torn(Trace& trace, std::uint64_t) {
  trace.torn = 9;
  return behind_all(trace);
}

Broken end_miscounts(Trace& trace, std::uint64_t) {
  const std::uint64_t k = behind_all(trace);
  trace.lines.back()["events"] = k + 1;
  return k;
}

Broken end_misdated(Trace& trace, std::uint64_t) {
  Json& t = trace.lines.back()["t"];
  t = clock_time(trace, since_start(trace, t) * 2 + 1);
  return behind_all(trace);
}

Broken event_behind_the_end(Trace& trace, std::uint64_t) {
  const std::vector<std::size_t> events = event_lines(trace);
  if (events.empty()) return {};
  const std::uint64_t k = behind_all(trace);
  trace.lines.push_back(trace.lines[events.back()]);
  trace.lines.back()["k"] = k + 1;
  trace.lines.back()["dt"] = "0x0p+0";
  return k;
}

Broken ended_twice(Trace& trace, std::uint64_t) {
  trace.lines.push_back(trace.lines.back());
  return behind_all(trace);
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
      {"nothing_more_claimed", "the run ends because nothing can happen, and something can", end,
       nothing_more_claimed},
      {"duration_claimed", "the run ends before its duration and says that it did not", end,
       duration_claimed},
      {"end_missing", "the last line is missing", end, end_missing},
      {"end_torn", "the last line is torn", end, end_torn},
      {"end_miscounts", "the last line counts one event more", end, end_miscounts},
      {"end_misdated", "the last line has another time", end, end_misdated},
      {"event_behind_the_end", "an event behind the last line", end, event_behind_the_end},
      {"ended_twice", "the last line comes twice", end, ended_twice},
      {"event_behind_the_duration", "an event later than the run lasts", end, event_behind_the_duration},
      {"stall_claimed", "a run that moves says that it stalled", progress, stall_claimed},
      {"stall_denied", "a run that stands still says that it ended otherwise", progress, stall_denied},
      {"stall_passed_over", "a run that stands still goes on", progress, stall_passed_over},
      {"progress_misdated", "a full state is wrong about when the clock last moved", states,
       progress_misdated},
  };
  return list;
}

std::vector<Mutation> mutations() {
  std::vector<Mutation> all;
  for (const auto* list : {&broken_lines(), &broken_times(), &broken_sequences(), &broken_impulses(),
                           &broken_velocities(), &broken_tethers(), &broken_groups(), &broken_loads(),
                           &broken_plans(), &broken_states(), &broken_ends()}) {
    all.insert(all.end(), list->begin(), list->end());
  }
  return all;
}

}  // namespace tps::mutation
