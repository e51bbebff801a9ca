// Which image of a particle in a periodic box is meant (docs/effects.md, "Periodic box").
#pragma once

#include <optional>

#include "reference/equations/dyadic.hpp"
#include "reference/equations/vector.hpp"

namespace tps {

/// B displaced by n_k edges along axis k. Along an open axis n and the edge are 0.
///
/// Positions are unwrapped and n are integers, so that u_B + n·edge − u_A has an exact value on the stored
/// numbers; difference() rounds it, exact_difference() does not.
template <typename Scalar, int D>
struct PeriodicImage {
  Vector<Scalar, D> n = Vector<Scalar, D>::Zero();
  Vector<Scalar, D> edges = Vector<Scalar, D>::Zero();

  Scalar shift(int k) const { return n[k] * edges[k]; }

  /// Three roundings: of the difference, the product and the sum, each of its own size, |n·edge| at most.
  Vector<Scalar, D> difference(const Vector<Scalar, D>& u_A, const Vector<Scalar, D>& u_B) const {
    Vector<Scalar, D> r;
    for (int k = 0; k < D; ++k) r[k] = (u_B[k] - u_A[k]) + shift(k);
    return r;
  }
  Dyadic exact_difference(const Vector<Scalar, D>& u_A, const Vector<Scalar, D>& u_B, int k) const {
    const Scalar &a = u_A[k], &b = u_B[k], &count = n[k], &edge = edges[k];
    return dyadic(b) - dyadic(a) + dyadic(count) * dyadic(edge);
  }
};

/// Where two particles are; in a periodic box also which image of the second is meant.
template <typename Scalar, int D>
struct PairPlaces {
  Vector<Scalar, D> u_i, u_j;
  std::optional<PeriodicImage<Scalar, D>> image;

  const PeriodicImage<Scalar, D>* exact() const { return image ? &*image : nullptr; }
  /// Positions whose difference is that of the two.
  Vector<Scalar, D> from() const { return image ? Vector<Scalar, D>(Vector<Scalar, D>::Zero()) : u_i; }
  Vector<Scalar, D> to() const { return image ? image->difference(u_i, u_j) : u_j; }
};

}  // namespace tps
