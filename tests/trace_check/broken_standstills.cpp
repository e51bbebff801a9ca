// Runs that stand still and do not say so, and the reverse.
#include "tests/trace_check/edits.hpp"

namespace tps::mutation {
namespace {

Broken stall_claimed(Trace& trace, std::uint64_t) {
  if (trace.lines.back().at("end") == "stalled") return {};
  return end_for(trace, "stalled");
}

Broken stall_denied(Trace& trace, std::uint64_t) {
  if (trace.lines.back().at("end") != "stalled") return {};
  return end_for(trace, "max_events");
}

/// A stalled run goes on as if nothing were the matter.
Broken stall_passed_over(Trace& trace, std::uint64_t) {
  if (trace.lines.back().at("end") != "stalled") return {};
  const std::uint64_t k = number_of_last(trace) + 1;
  const std::vector<std::size_t> events = event_lines(trace);
  const std::size_t behind = events.back() + 1;
  constexpr std::size_t kMore = 4;  // two anchors pull in turn
  for (std::size_t n = 0; n < kMore; ++n) {
    insert_line(trace, behind + n, Json(trace.lines[events[events.size() - kMore + n]]));
  }
  trace.lines.change_last()["end"] = "max_events";
  settle(trace);
  return k;
}

Broken progress_misdated(Trace& trace, std::uint64_t) {
  Json& state = trace.lines.change(*last_state(trace));
  if (state.at("state") == 0) return {};
  state["progress_event"] = state.at("progress_event").get<std::uint64_t>() + 1;
  return state.at("state").get<std::uint64_t>();
}

}  // namespace

const std::vector<Mutation>& broken_standstills() {
  using enum check::Rule;
  static const std::vector<Mutation> list = {
      {"stall_claimed", "a run that moves says that it stalled", progress, stall_claimed},
      {"stall_denied", "a run that stands still says that it ended otherwise", progress, stall_denied},
      {"stall_passed_over", "a run that stands still goes on", progress, stall_passed_over},
      {"progress_misdated", "a full state is wrong about when the clock last moved", states,
       progress_misdated},
  };
  return list;
}

}  // namespace tps::mutation
