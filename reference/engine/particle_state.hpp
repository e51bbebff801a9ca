// What is stored of a particle's flight.
#pragma once

#include "reference/engine/clock.hpp"
#include "reference/equations/vector.hpp"

namespace tps {

/// A particle where it was when its velocity last changed; from there it flies straight. In space and in
/// double it fills a cache line; elsewhere it is aligned as its vectors are.
template <typename Scalar, int D>
struct alignas(sizeof(Scalar) * (2 * D + 2) == 64 ? 64 : alignof(Vector<Scalar, D>)) ParticleState {
  Vector<Scalar, D> position, velocity;
  Time<Scalar> clock;

  /// Where it is a time after its clock.
  Vector<Scalar, D> after(const Scalar& dt) const {
    Vector<Scalar, D> place;
    for (int k = 0; k < D; ++k) place[k] = position[k] + velocity[k] * dt;
    return place;
  }
};

}  // namespace tps
