// What a run has now of the quantities that the ledger follows.
#pragma once

#include "reference/engine/world.hpp"
#include "reference/equations/square_root.hpp"
#include "reference/equations/weighted_square.hpp"

namespace tps {

/// ½ Σ m |v − V|² over finite masses, V the velocity of the infinite ones.
template <typename Scalar, int D>
Scalar kinetic_energy(const World<Scalar, D>& world) {
  Sum<Scalar> sum;
  for (int i = 0; i < world.size(); ++i) {
    if (world.fixed(i)) continue;
    const Vector<Scalar, D> v = world.velocity(i) - world.frame_velocity();
    sum += weighted_square<Scalar, D>(world.mass(i), v) / Scalar(2);
  }
  return sum.value();
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

/// value · 2^exponent, the exponent even.
template <typename Scalar>
struct ScaledSum {
  Scalar value{0};
  int exponent = 0;
};

/// M, the sum of the finite masses.
template <typename Scalar, int D>
ScaledSum<Scalar> mass_in_all(const World<Scalar, D>& world) {
  using std::frexp;
  using std::ldexp;
  ScaledSum<Scalar> sum;
  for (int i = 0; i < world.size(); ++i) {
    int exponent = 0;
    if (!world.fixed(i)) static_cast<void>(frexp(world.mass(i), &exponent));
    if (exponent > sum.exponent) sum.exponent = exponent;
  }
  sum.exponent += sum.exponent % 2;
  for (int i = 0; i < world.size(); ++i) {
    if (!world.fixed(i)) sum.value += ldexp(world.mass(i), -sum.exponent);
  }
  return sum;
}

/// What computing the ledger's sums rounds away, also of particles that no event touched (docs/ledger.md).
template <typename Scalar>
struct BoundOfSums {
  Scalar momentum, energy;
};

/// A product that underflows loses up to the smallest number: in sums of energies or momenta two of them a
/// particle, at the start and at the end.
template <typename Scalar>
Scalar bound_of_underflow(std::size_t particles) {
  return Scalar(4) * Scalar(particles) * std::numeric_limits<Scalar>::denorm_min();
}

/// Kinetic energies K and momenta are summed at the start and at the end: u of each term a few times, 8 in
/// all. Σ m|v| ≤ √(2MK) + M|V|, by Cauchy, and forming v − V costs u (|v| + |V|) of it.
/// M, a sum of masses that are each in the range, need not be; nor need the sums of energies before the u.
template <typename Scalar, int D>
BoundOfSums<Scalar> bound_of_sums(const World<Scalar, D>& world, const Scalar& kinetic) {
  using std::abs;
  using std::ldexp;
  const Ledger<Scalar, D>& ledger = world.ledger;
  using Limits = std::numeric_limits<Scalar>;
  const ScaledSum<Scalar> mass = mass_in_all(world);
  const Scalar V = norm<Scalar, D>(world.frame_velocity());
  const Scalar share = Scalar(4) * Limits::epsilon();  // 8 u, a power of two
  // Energies below the normal numbers are short of what they are by as much as their products lost.
  const Scalar underflow = bound_of_underflow<Scalar>(world.particles.size());
  const Scalar roots = share * Scalar(square_root(Scalar(kinetic + underflow)) +
                                      square_root(Scalar(ledger.kinetic_at_start + underflow)));
  const Scalar moving = ldexp(Scalar(square_root(Scalar(2) * mass.value) * roots), mass.exponent / 2);
  Scalar given(0);
  for (int k = 0; k < D; ++k) {
    const auto n = static_cast<std::size_t>(k);
    given += share * abs(ledger.from_walls[n].value()) + share * abs(ledger.from_outside[n].value());
  }
  const Scalar energies = share * kinetic + share * ledger.kinetic_at_start +
                          share * abs(ledger.stored.value()) + share * abs(ledger.lost.value()) +
                          share * abs(ledger.work.value());
  const Scalar carried = ldexp(Scalar(share * Scalar(2) * mass.value * V), mass.exponent);
  return {moving + carried + given + underflow, energies + V * moving + underflow};
}

}  // namespace tps
