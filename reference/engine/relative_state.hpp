// Where one particle is from another, without the vectors from which that follows: what most questions about
// pairs are decided by.
#pragma once

#include <cmath>
#include <optional>

#include "reference/engine/world.hpp"

namespace tps {

/// The numbers of World::view(), or of imaged_view(), relative to each other, by the same operations; nothing
/// where the image is not to be told from them alone.
template <typename Scalar, int D>
std::optional<RelativeState<Scalar, D>> relative_state(const World<Scalar, D>& world, int i, int j,
                                                       const Time<Scalar>& t) {
  using std::abs;
  const ParticleState<Scalar, D>& a = world.particles[world.index(i)];
  const ParticleState<Scalar, D>& b = world.particles[world.index(j)];
  const bool is_a_earlier = a.clock < b.clock;
  const Time<Scalar>& start = is_a_earlier ? b.clock : a.clock;
  if (world.box && !(start == t)) return std::nullopt;
  const bool is_one_clock = a.clock == b.clock;
  const Scalar dt = is_one_clock ? Scalar(0) : elapsed(is_a_earlier ? a.clock : b.clock, start);
  std::optional<RelativeState<Scalar, D>> pair(std::in_place);
  for (int k = 0; k < D; ++k) {
    Scalar u_a = a.position[k];
    Scalar u_b = b.position[k];
    if (!is_one_clock && is_a_earlier) u_a = u_a + a.velocity[k] * dt;
    if (!is_one_clock && !is_a_earlier) u_b = u_b + b.velocity[k] * dt;
    pair->r[k] = u_b - u_a;
    pair->v[k] = b.velocity[k] - a.velocity[k];
    pair->size[k] = abs(pair->r[k]);
    if (!world.box) continue;
    if (!world.box->knows(u_a) || !world.box->knows(u_b)) return std::nullopt;
    const Scalar shift = world.box->shift(k, pair->r[k]);
    pair->r[k] += shift;
    pair->size[k] += abs(shift);
  }
  return pair;
}

}  // namespace tps
