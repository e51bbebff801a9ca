// What a trace says of itself in its header, and how it is to be judged.
#pragma once

#include "reference/engine/timing.hpp"
#include "reference/scene/scene.hpp"

namespace tps::check {

struct TraceFacts {
  const Scene& scene;
  Timing timing;
  bool minimal;
  int semantics = 0;       ///< 0: the trace does not say
  bool eager = false;      ///< everybody is advanced at every event, and rounded each time
  bool own_draws = false;  ///< draws are those of the scene's seed by our generator
};

}  // namespace tps::check
