// What a run has now of the quantities that the ledger follows.
#pragma once

#include "reference/engine/world.hpp"

namespace tps {

/// ½ Σ m |v − V|² over finite masses, V the velocity of the infinite ones.
template <typename Scalar, int D>
Scalar kinetic_energy(const World<Scalar, D>& world) {
  Sum<Scalar> twice;
  for (int i = 0; i < world.size(); ++i) {
    if (world.fixed(i)) continue;
    const Vector<Scalar, D> v = world.velocity(i) - world.frame_velocity();
    twice += world.mass(i) * v.squaredNorm();
  }
  return twice.value() / Scalar(2);
}

/// Σ m v over finite masses.
template <typename Scalar, int D>
Vector<Scalar, D> momentum(const World<Scalar, D>& world) {
  Vector<Scalar, D> total;
  for (int k = 0; k < D; ++k) {
    Sum<Scalar> sum;
    for (int i = 0; i < world.size(); ++i) {
      if (!world.fixed(i)) sum += world.mass(i) * world.velocity(i)[k];
    }
    total[k] = sum.value();
  }
  return total;
}

}  // namespace tps
