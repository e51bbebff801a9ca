// From the lines of a trace to what a page plays.
#pragma once

#include <string>
#include <vector>

#include "verify/trace_check/line.hpp"
#include "verify/view/body_trees.hpp"
#include "verify/view/playback.hpp"

namespace tps::view {

/// Adds events to a playback, in the order of the trace, whatever its numbers are.
class Recorder {
 public:
  explicit Recorder(Playback& playback);

  template <typename Number>
  void event(const check::EventLine<Number>& line, std::uint64_t number) {
    const double t = narrow(line.t.hi) + narrow(line.t.lo);
    begin(t, line.kind, number, line.k.value_or(playback_.all_events + 1));
    Event& event = playback_.events.back();
    event.i = line.i;
    event.j = line.j;
    event.has_dp = line.dp.has_value();
    if (line.dp) event.dp = narrow(*line.dp);
    event.formed = line.formed.value_or(false);
    event.broken = line.formed.has_value() && !*line.formed;
    for (const auto& p : line.involved) {
      const auto& place = p.position_after ? p.position_after : p.position_before;
      if (place) put(p.particle, narrow(*place));
      set_velocity(p.particle, narrow(p.velocity_after));
    }
    if (line.dv) everybody_gains(narrow(*line.dv));
    follow_bodies(line.members);
    follow_tether();
  }

 private:
  template <typename Number>
  static double narrow(const Number& x) {
    return static_cast<double>(x);
  }
  template <typename Number>
  static Coordinates narrow(const check::Vec<Number>& v) {
    return {narrow(v[0]), narrow(v[1]), narrow(v[2])};
  }

  void begin(double t, check::Kind kind, std::uint64_t line, std::uint64_t k);
  void put(int particle, const Coordinates& position);
  void set_velocity(int particle, const Coordinates& velocity);
  void everybody_gains(const Coordinates& dv);
  void follow_bodies(const std::vector<int>& members);
  void follow_tether();
  Change& changed(int particle);

  Playback& playback_;
  BodyTrees bodies_;
  std::vector<Change> now_;                   ///< the last change of each particle
  std::vector<std::size_t> change_of_event_;  ///< where each particle's change of this event is, or none
  std::vector<int> in_event_;                 ///< who has one
  double t_ = 0;
};

}  // namespace tps::view
