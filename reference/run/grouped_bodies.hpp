// Bodies that collide at one moment and are grouped: what `group` asks (docs/protocol.md), answered by the
// engine's own grouping in any scalar.
#pragma once

#include <string>
#include <vector>

#include "reference/engine/state_data.hpp"
#include "reference/engine/tethers.hpp"
#include "reference/run/run.hpp"
#include "reference/scene/scene.hpp"

namespace tps {

struct GroupedBodies {
  struct Body {
    double mass;
    Coordinates position, velocity;
  };
  /// Of bodies i and j, by their places in the list: Δp of eq. (4) with c_rebound at the inner limit, of eqs.
  /// (4) and (5) at the outer one.
  struct Collision {
    int i, j;
    Limit limit;
    double c;  ///< c_rebound or c_retract
    double c_revolve = 1, theta_revolve_deg = 0;
  };
  int dimension = 3;
  std::vector<Body> bodies;
  std::vector<Collision> collisions;  ///< one after the other
};

struct GroupedVelocities {
  std::vector<HexVector> loaded;      ///< after all loads, eq. (6)
  std::vector<HexVector> restituted;  ///< after all restitutions, eqs. (7) and (3)
  std::string out_of_range = {};      ///< what left the range of the scalar, if anything did
};

/// REQUIRES that no two bodies that collide are at one place, or in one group already.
GroupedVelocities group_bodies(const GroupedBodies& question, ScalarKind scalar);

}  // namespace tps
