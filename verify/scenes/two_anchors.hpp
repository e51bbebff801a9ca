// A particle between two taut tethers: the smallest scene that stalls without grouping.
#pragma once

#include "verify/scenes/builder.hpp"

namespace tps {

/// The particle has mass 1 and diameter 1/4, tethers have length 1.
struct TwoAnchorsParams {
  double speed = 1;
  double c_retract = 1;
  double grouped = 0;
  double duration = 1;
};

/// Two fixed particles (infinite mass) two tether lengths apart and one between them, tethered to both, that
/// wants to move towards one of them. Both tethers are taut whatever it does: each retraction makes the other
/// tether due at the same instant, so the clock stands still. Grouped, every retraction holds the particle
/// for dt_restitute.
Scene build_two_anchors(const TwoAnchorsParams& params);
SceneBuilder two_anchors_builder();

}  // namespace tps
