// What laws of runs between walls have in common: how near a particle may seem to come, and eq. (4) with an
// infinite mass at rest.
#pragma once

#include <algorithm>
#include <optional>
#include <string>

#include "properties/runs/laws.hpp"
#include "properties/runs/scene_bounds.hpp"

namespace tps::properties::runs {

inline Real radius_of(const Scene& scene, const ImpliedState& implied, int i) {
  return implied.stored(scene.species[at(scene.particles[at(i)].species)].radius);
}

/// Landing errs by 16 u of coordinates and limits, flight by 64 u of its way, which in a box, the first wall,
/// is below its size (docs/engine.md).
inline Real slack_between_walls(const Scene& scene, Real u) {
  const Wall& box = scene.walls[0];
  const Real size = (point_of(box.high) - point_of(box.point)).norm();
  const Real coordinates = point_of(box.high).norm() + point_of(box.point).norm();
  return 80 * u * kSpare * (size + coordinates);
}

/// A particle at a wall that is `gap` from touching along the unit vector n, from the wall to the particle,
/// which may be turned by `turn` through the ulps of its places.
inline std::optional<std::string> rebounds_wrongly_at(const Scene& scene, const ImpliedState& before,
                                                      const TracedEvent& event, const Point& n, Real gap,
                                                      Real turn, Real u) {
  const int i = before.index_of(*event.i);
  const TracedState &pre = event.pre.at(*event.i), &post = event.post.at(*event.i);
  const Real speed = pre.velocity.norm(), v_n = n.dot(pre.velocity);
  const Real rounding = (32 * u + turn) * kSpare * speed;
  if (auto fault = beyond("distance from the wall's limit", std::abs(gap), slack_between_walls(scene, u)))
    return fault;
  if (auto fault = beyond("velocity away from the wall before it", v_n, rounding)) return fault;
  if (auto fault = beyond("velocity into the wall after it", -n.dot(post.velocity), rounding)) return fault;
  const Real c = scene.walls.at(event.wall.value()).c_rebound;
  const Point expected = pre.velocity - (1 + c) * std::min(v_n, Real(0)) * n;
  if (auto fault = beyond("velocity after the wall, against eq. (4),", (post.velocity - expected).norm(),
                          2 * rounding))
    return fault;
  const Point given = before.mass(i) * (post.velocity - pre.velocity);
  return beyond("impulse of the wall, against what it did,", (event.dp.value() - given).norm(),
                before.mass(i) * 2 * rounding);
}

}  // namespace tps::properties::runs
