// A detector: keeps the events of pairs that lie ahead. Which pairs it asks, and when, is its own affair; the
// events that it hands out are those of all pairs.
#pragma once

#include <vector>

#include "reference/engine/detector_kind.hpp"
#include "reference/engine/world.hpp"

namespace tps {

template <typename Scalar, int D>
class Detector {
 public:
  using Event = PendingEvent<Scalar>;

  virtual ~Detector() = default;

  /// Starts anew on the present states. Throws OutOfRange.
  virtual void predict_all(World<Scalar, D>& world) = 0;

  /// An event has touched these particles (ascending). Throws OutOfRange.
  virtual void predict_touched(World<Scalar, D>& world, const std::vector<int>& touched) = 0;

  /// The time of the earliest event of a pair, where that is at or before `limit`; else a time beyond `limit`
  /// that is not after it, or never(). Throws OutOfRange.
  virtual Time<Scalar> earliest(World<Scalar, D>& world, const Time<Scalar>& limit) = 0;

  /// Appends every event of a pair at or before `latest`, each once, in any order. They stay: what voids an
  /// event is a touch of one of its particles. Throws OutOfRange.
  virtual void collect(World<Scalar, D>& world, const Time<Scalar>& latest, std::vector<Event>& events) = 0;
};

}  // namespace tps
