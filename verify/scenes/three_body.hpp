// The paper's X, Y and Z.
#pragma once

#include "verify/scenes/builder.hpp"

namespace tps {

/// X and Z have mass 1 and diameter 1.
struct ThreeBodyParams {
  double middle_mass = 0.001;
  double restitution = 1;
  double gap = 0.015625;
  double grouped = 0;
};

/// On a line: X moves with velocity 1 towards Y, Y and Z rest. X meets Y at t = 1; `gap` is what then lies
/// between Y and Z. Distances and radii are exact in binary, and so is the whole run in any scalar but for
/// the masses. Ungrouped it lasts until nothing happens any more (duration inf): X-Z never meet, so 70
/// collisions is all there is at c = 1 and m_Y = 1/1000. Grouped with dt_restitute above gap·(1 + m_Y) the
/// second collision falls into the first group, and there are two; it ends at 2 + 4 dt_restitute, when both
/// groups have been restituted.
Scene build_three_body(const ThreeBodyParams& params);
SceneBuilder three_body_builder();

}  // namespace tps
