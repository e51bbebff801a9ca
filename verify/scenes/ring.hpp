// A taut ring of twelve.
#pragma once

#include "verify/scenes/builder.hpp"

namespace tps {

/// The ring's radius is 1; particles have mass 1 and half a chord's diameter.
struct RingParams {
  double speed = 1;
  double restitution = 0.9;
  double grouped = 0.001;
  double duration = 5;
};

/// Twelve particles on a circle, each tethered to its two neighbours at exactly the tether's length but for
/// rounding, all moving outwards with `speed`: twelve tethers are due at t = 0. Twelve, because the
/// coordinates then need only √3, which rounds alike everywhere; sines of other angles do not.
Scene build_ring(const RingParams& params);
SceneBuilder ring_builder();

}  // namespace tps
