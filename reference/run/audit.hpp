// Every distance bound of a scene, looked at once.
#pragma once

#include <algorithm>
#include <cmath>

#include "reference/engine/response.hpp"
#include "reference/engine/world.hpp"

namespace tps {

/// The most that any pair is nearer than its inner or farther than its outer limit, in ulps of the pair's
/// largest coordinate; zero where none is.
template <typename Scalar>
struct BoundExcess {
  Scalar inner{0};
  Scalar outer{0};
};

/// Looks at all pairs, N(N − 1)/2 distances, at a time up to which every particle flies straight.
template <typename Scalar, int D>
BoundExcess<Scalar> audit_bounds(const World<Scalar, D>& world, const Time<Scalar>& t) {
  std::vector<Vector<Scalar, D>> at;
  for (int i = 0; i < world.size(); ++i) at.push_back(world.position(i, t));
  BoundExcess<Scalar> worst;
  for (int i = 0; i < world.size(); ++i) {
    for (int j = i + 1; j < world.size(); ++j) {
      const Law<Scalar>& law = world.law(i, j);
      if (!law.blocking && !law.tethering) continue;
      const Vector<Scalar, D>& u_i = at[world.index(i)];
      const Vector<Scalar, D>& u_j = at[world.index(j)];
      const Scalar distance = norm<Scalar, D>(u_j - u_i);
      const Scalar ulp = coordinate_ulp<Scalar, D>(u_i, u_j);
      if (law.blocking)
        worst.inner = std::max(worst.inner, Scalar((law.blocking->distance - distance) / ulp));
      if (world.tethered(i, j)) {
        worst.outer = std::max(worst.outer, Scalar((distance - law.tethering->distance) / ulp));
      }
    }
  }
  return worst;
}

}  // namespace tps
