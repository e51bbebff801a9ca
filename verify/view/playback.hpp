// What the page of a trace plays: events, and where each particle flies from after each of them, in doubles.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "reference/scene/scene.hpp"
#include "verify/trace_check/line.hpp"

namespace tps::view {

/// Times count from the start of the run.
struct Event {
  double t = 0;
  double dt = 0;
  std::uint64_t number = 0;  ///< in the order of the trace, from 1
  std::uint64_t k = 0;       ///< as the trace has it
  std::uint64_t line = 0;    ///< of the trace
  check::Kind kind = check::Kind::rebound;
  int i = -1, j = -1;  ///< indices into Scene::particles; -1: none
  bool has_dp = false;
  Coordinates dp{};  ///< on i
  bool formed = false, broken = false;
  bool load = false;             ///< bodies were joined
  std::size_t first_change = 0;  ///< of its changes; they end where those of the next event begin
};

/// From time t on a particle flies straight from `position` with `velocity`, until its next change.
struct Change {
  double t = 0;
  int particle = 0;
  int body = -1;  ///< number of the load that it moves with; -1: with none
  Coordinates position{}, velocity{};
};

struct TetherChange {
  double t = 0;
  int i = 0, j = 0;
  bool formed = true;
};

/// (1) Times do not decrease. (2) Where `one_of` is 1, a particle's position at any time is that of its last
/// change plus velocity times the time since; otherwise changes between the events that were kept are
/// missing, all but the last of each particle.
struct Playback {
  Scene scene;
  std::string scalar = "double", timing = "stable";
  std::string end;   ///< the reason the trace gives; empty if it gives none
  double t_end = 0;  ///< of the run, or of what the trace has of it
  std::vector<Event> events;
  std::vector<Change> changes;
  std::vector<TetherChange> tethers;
  std::uint64_t all_events = 0;    ///< of the trace
  std::uint64_t one_of = 1;        ///< of so many events one was kept
  std::vector<std::string> notes;  ///< what of the trace could not be taken as it stands
};

struct PlaybackOptions {
  std::string scene;                    ///< of a trace that lacks its own; empty: none
  std::uint64_t most_events = 200'000;  ///< more are thinned out
  std::vector<std::uint64_t> lines;     ///< ascending; the events there and beside are always kept
  std::function<bool()> stop = [] { return false; };
};

/// Reads a trace of anybody's, as the check reads it (docs/check.md); "-" is the standard input. A line that
/// is none of a trace is passed over and noted: what is wrong with it is for the check to say. Throws
/// InputError where there is nothing to play: no file, no header, a broken scene.
Playback read_playback(const std::string& trace, const PlaybackOptions& options = {});

/// A scene before anything has happened.
Playback start_of(Scene scene);

/// Drops the events whose number is no multiple of `one_of`, but the last one and those that `keep` wants;
/// what happened to a particle meanwhile is told by its last change.
void thin(Playback& playback, const std::function<bool(const Event&)>& keep);

}  // namespace tps::view
