// An impulse that no other particle gives.
#pragma once

#include "reference/engine/world.hpp"
#include "reference/equations/weighted_square.hpp"

namespace tps {

/// An impulse from outside on the body of a particle, as an event: momentum, work and velocity.
/// @return the work
template <typename Scalar, int D>
Scalar push_from_outside(World<Scalar, D>& world, int i, const Vector<Scalar, D>& J,
                         Record<Scalar, D>& record) {
  record.dp = J;
  const Scalar body_mass = world.coupling->body_mass(world, i);
  const Vector<Scalar, D> v = world.velocity(i) - world.frame_velocity();
  const Scalar work = J.dot(v) + square_over<Scalar, D>(J, body_mass) / Scalar(2);
  world.ledger.work += work;
  world.ledger.add_from_outside(J);
  world.coupling->push(world, i, J, record);
  return work;
}

}  // namespace tps
