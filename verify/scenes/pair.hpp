// Two particles that circle each other on a tether.
#pragma once

#include "verify/scenes/builder.hpp"

namespace tps {

/// Masses 1; the tether's length is 1, the particles' diameter 1/2.
struct PairParams {
  double theta = 45;
  double c_revolve = 0.5;
  double c_retract = 0.5;
  double speed = 1;
  double duration = 10;
};

/// The tether is taut at t = 0 and the relative velocity `speed` tangential, so the first revolution (eq. 5)
/// is due at once. At the defaults revolutions follow at 1.681793, 3.681793, 6.060207, 8.888634, four a turn,
/// each keeping 0.5^(1/4) of the speed. A chord stays clear of blocking as long as cos θ > 1/2. With
/// c_retract = 1 the orbit sits on the boundary between retraction and revolution (docs/decisions.md).
Scene build_pair(const PairParams& params);
SceneBuilder pair_builder();

}  // namespace tps
