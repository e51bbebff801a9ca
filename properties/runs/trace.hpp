// A run as a reader of its trace sees it (docs/trace.md).
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "properties/runs/judge.hpp"

namespace tps::properties::runs {

/// A particle at an event.
struct TracedState {
  Point position = Point::Zero(), velocity = Point::Zero();
  std::optional<Point> spin = {};  ///< where friction acted; in the plane along z
  bool operator==(const TracedState&) const = default;
};

/// One event; particles by id.
struct TracedEvent {
  std::uint64_t k = 0;
  Instant t;                      ///< on the scene's clock; with drag on the run's, s
  std::optional<Real> time = {};  ///< with drag: what is printed beside s
  Real dt = 0;                    ///< since the event before, as the run rounded it
  std::string kind;
  std::optional<std::int32_t> i, j;
  std::map<std::int32_t, TracedState> pre, post;
  std::optional<Point> dp, dp_stored;
  std::vector<std::int32_t> members;
  std::optional<bool> sticks = {};  ///< where friction acted
  std::string tether;               ///< "formed", "broken" or empty
  std::optional<Real> draw;
  int phase = -1;
  std::optional<std::size_t> wall = {};  ///< of the scene, at a wall
  std::optional<int> face = {};          ///< of a box

  bool is_collision() const { return kind == "rebound" || kind == "retract" || kind == "revolve"; }
  bool is_load() const { return !members.empty(); }
  bool operator==(const TracedEvent&) const = default;
};

struct RunTrace {
  std::vector<std::string> lines;  ///< all, without their ends
  std::vector<TracedEvent> events;
  std::string end;  ///< why the run ended; empty for a truncated trace
  Instant end_time;
  std::string bytes() const;
};

/// Whether a trace is in the minimal form, which has no states before events: most laws cannot judge it.
bool is_minimal(std::string_view bytes);

/// A trace that a law cannot judge.
class MinimalTrace : public std::runtime_error {
 public:
  explicit MinimalTrace(std::string trace)
      : std::runtime_error(
            "the trace is minimal: it lacks what laws of runs judge by; `tps check` judges it"),
        bytes(std::move(trace)) {}
  std::string bytes;
};

/// Reads a whole trace in the full form; a line that is neither header, event, state nor end is an error.
/// Throws InputError, or std::runtime_error that names the line and what it lacks.
RunTrace read_trace(std::string_view bytes);

}  // namespace tps::properties::runs
