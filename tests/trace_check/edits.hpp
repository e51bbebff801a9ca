// The steps of which mutations are made.
#pragma once

#include <optional>

#include "tests/trace_check/mutation.hpp"

namespace tps::mutation {

inline std::uint64_t number_of(const Trace& trace, std::size_t line) {
  return trace.lines[line].at("k");
}

/// The number of the last event, by the last line.
std::uint64_t number_of_last(const Trace& trace);
/// Gives the end another reason; what is wrong is behind the last event.
Broken end_for(Trace& trace, const char* reason);

void erase_line(Trace& trace, std::size_t line);
void insert_line(Trace& trace, std::size_t line, Json text);

/// Ends the trace behind `line`: later events go, the final state and the end stay and are settled. The final
/// state is what the first one and the events make of positions, velocities and clocks.
void cut_behind(Trace& trace, std::size_t line);

/// Gives an event another time, before or behind (`since` counts from the start), and nothing else.
void move_event(Trace& trace, std::size_t line, double since);
/// The same with everybody involved at the place where the flight leads by then.
void carry_event(Trace& trace, std::size_t line, const Retold& before, double since);

/// Gives a collision another impulse, and all that follows from it in the trace: eq. (3) in its own `post`
/// or, where bodies were loaded, eq. (7) and the restitution of the node.
void set_impulse(Trace& trace, const Place& place, const Vec& dp);
/// Where bodies that a line has loaded are parted; nothing if the trace ends before.
std::optional<std::size_t> restitution_of(const Trace& trace, std::size_t load);
/// Gives velocities after an event by eq. (3), from those before.
void part_by(Trace& trace, Json& event, const double (&masses)[2], const Vec& dp);

/// The law of the limit at which a collision is.
double coefficient(const Place& place);

/// The last full state.
std::optional<std::size_t> last_state(const Trace& trace);
/// The state of a particle in a full state.
Json& particle_of(Json& state, int id);

/// Breaks the first event that meets a condition and can be broken: `edit(trace, line, before)`.
template <typename Condition, typename Edit>
Broken at_event(Trace& trace, std::uint64_t number, Condition meets, Edit edit) {
  const auto found = find_event(trace, number, meets);
  if (!found) return {};
  const std::uint64_t k = number_of(trace, found->line);
  edit(found->line, found->before);
  return k;
}

}  // namespace tps::mutation
