// The input of `group`.
#pragma once

#include <cstddef>
#include <vector>

namespace tps::operations {

/// Bodies at one instant and the collisions that group them (semantics §4).
struct GroupInput {
  struct Body {
    double mass;  ///< above 0, infinity allowed
    std::vector<double> position, velocity;
  };
  struct Collision {
    std::size_t i, j;    ///< places in `bodies`
    bool outer = false;  ///< a tethering collision: tether_response; else eq. (4) with c
    double c = 0;
    double c_retract = 0, c_revolve = 0, theta_revolve_deg = 0;
  };
  std::vector<Body> bodies;
  std::vector<Collision> collisions;
};

}  // namespace tps::operations
