// What a run has now of the quantities that the ledger follows.
#pragma once

#include "reference/engine/world.hpp"
#include "reference/equations/square_root.hpp"

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

/// What computing the ledger's sums rounds away, also of particles that no event touched (docs/ledger.md).
template <typename Scalar>
struct BoundOfSums {
  Scalar momentum, energy;
};

/// Kinetic energies K and momenta are summed at the start and at the end: u of each term a few times, 8 in
/// all. Σ m|v| ≤ √(2MK) + M|V|, by Cauchy, and forming v − V costs u (|v| + |V|) of it.
template <typename Scalar, int D>
BoundOfSums<Scalar> bound_of_sums(const World<Scalar, D>& world, const Scalar& kinetic) {
  using std::abs;
  const Ledger<Scalar, D>& ledger = world.ledger;
  Scalar mass(0);
  for (int i = 0; i < world.size(); ++i) {
    if (!world.fixed(i)) mass += world.mass(i);
  }
  const Scalar V = norm<Scalar, D>(world.frame_velocity());
  const Scalar moving =
      square_root(Scalar(2) * mass) * Scalar(square_root(kinetic) + square_root(ledger.kinetic_at_start));
  Scalar given(0);
  for (int k = 0; k < D; ++k) {
    const auto n = static_cast<std::size_t>(k);
    given += abs(ledger.from_walls[n].value()) + abs(ledger.from_outside[n].value());
  }
  const Scalar energies = kinetic + ledger.kinetic_at_start + abs(ledger.stored.value()) +
                          abs(ledger.lost.value()) + abs(ledger.work.value());
  const Scalar share = Scalar(4) * std::numeric_limits<Scalar>::epsilon();  // 8 u
  return {share * (moving + Scalar(2) * mass * V + given), share * (energies + V * moving)};
}

}  // namespace tps
