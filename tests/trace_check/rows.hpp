// Scenes of rows far apart in which events nearly or exactly coincide, and traces of them as lies are made
// of.
#pragma once

#include <cstdint>
#include <string>

#include "reference/run/run.hpp"
#include "tests/trace_check/broken_trace.hpp"

namespace tps::mutation {

/// What happens in the rows of a scene.
enum class Rows {
  ties,       ///< pairs meet at exactly the same moments
  near_ties,  ///< at moments a few roundings apart
  grazes,     ///< pairs pass each other at their limit, a few roundings to either side
  bodies,     ///< pairs that meet at the same moments are loaded, and part at the same moments
  planned,    ///< pairs meet when impulses come and windows open and close
  tethered,   ///< tethers are pulled
};
constexpr Rows kRows[] = {Rows::ties,   Rows::near_ties, Rows::grazes,
                          Rows::bodies, Rows::planned,   Rows::tethered};

/// A scene of 3 to 6 rows; ids have nothing to do with rows.
Scene scene_of_rows(Rows rows, std::uint64_t seed);

/// How a trace is made.
struct Making {
  std::string scalar = "double";
  Timing timing = Timing::certified;
};
/// The trace of a run, without its full states.
Trace run_of(const Scene& scene, const Making& making, RunOptions options = {});

/// The trace in other units: lengths times 2^length, velocities times 2^speed. Exact where nothing leaves the
/// range of double.
Trace in_units(const Trace& trace, int length, int speed);

/// The trace up to an event, with another end. `t` is an exact time of the scene's clock; for reasons other
/// than "duration" that of the last event.
Trace ended_behind(const Trace& trace, std::size_t events, const char* reason, const std::string& t);

}  // namespace tps::mutation
