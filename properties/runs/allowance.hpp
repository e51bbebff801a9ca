// How far a run may be from its limits: roundings of coordinates, and the creep that docs/engine.md
// describes.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "properties/runs/implied_state.hpp"

namespace tps::properties::runs {

/// The largest distance by which rounding can have put a pair beyond a limit L.
///
/// Landing at a limit, a pair misses it by
/// - the time of eq. (2): a few u (|r| + L) (docs/eq2.md, law 4), |r| ≤ |u_i| + |u_j|;
/// - carrying either particle to the later clock and to the event: 3 u of each coordinate and of the path,
/// twice. With x the largest |u| that a particle has had, that is less than 16 u (x_i + x_j + L); at the
/// outer limit with a small θ it adds up over the pair's events (random walk, docs/engine.md). After a
/// response the pair's relative velocity is wrong by at most 64 u (s_i + s_j), s the largest speeds so far;
/// where real arithmetic has it at rest (c = 0) it creeps at that speed until something else touches one of
/// the two: 64 u ∫ s dt for each.
class Allowance {
 public:
  Allowance(const ImpliedState& start, Real roundoff);

  /// Up to t every particle flies as `implied` has it. Called with ascending t.
  void fly(const ImpliedState& implied, const Instant& t);
  /// fly() to an event, and what it does.
  void note(const ImpliedState& before, const TracedEvent& event);

  Real distance(int i, int j, Real limit) const;
  /// Of a velocity along the axis of a pair that stands `distance()` beside its limit, v its relative speed.
  Real normal_speed(int i, int j, Real limit, Real v) const;

 private:
  struct Largest {
    Real coordinate, speed;
    Real path = 0;  ///< ∫ s dt
  };
  Real u_;
  Instant now_;
  std::vector<Largest> largest_;
  std::map<std::pair<int, int>, int> events_;
};

}  // namespace tps::properties::runs
