// Vectors of the paper: columns of D numbers of any scalar type, D = 2 or 3; length, direction (docs/eq1.md).
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>

#include "reference/equations/square_root.hpp"

namespace tps {

/// A position, velocity or impulse in D dimensions.
template <typename Scalar, int D>
using Vector = Eigen::Matrix<Scalar, D, 1>;

/// Calls use(k) for every axis. Not a loop: a compiler keeps one, however short, where these lines are inside
/// another one.
template <int D, typename Use>
[[gnu::always_inline]] inline void for_each_axis(Use use) {
  static_assert(D == 2 || D == 3);
  use(0);
  use(1);
  if constexpr (D == 3) use(2);
}

/// Whether x is a number of the scalar's range: neither infinite nor NaN.
template <typename Scalar>
bool is_finite(const Scalar& x) {
  using std::abs;
  return abs(x) <= (std::numeric_limits<Scalar>::max)();
}

template <typename Scalar, int D>
bool is_finite(const Vector<Scalar, D>& x) {
  for (int k = 0; k < D; ++k) {
    if (!is_finite<Scalar>(x[k])) return false;
  }
  return true;
}

/// The power of two that brings x into the range where squares neither overflow nor underflow: 0, that is
/// "as it is", for most vectors, else minus the exponent of the largest component.
template <typename Scalar, int D>
int comfortable_shift(const Vector<Scalar, D>& x) {
  using std::abs;
  using std::frexp;
  using std::ldexp;
  static const Scalar small = ldexp(Scalar(1), std::numeric_limits<Scalar>::min_exponent / 4);
  static const Scalar large = ldexp(Scalar(1), std::numeric_limits<Scalar>::max_exponent / 4);
  Scalar largest(0);
  for (int k = 0; k < D; ++k) {
    if (abs(x[k]) > largest) largest = abs(x[k]);
  }
  if (largest == Scalar(0) || (largest > small && largest < large)) return 0;
  int exponent = 0;
  static_cast<void>(frexp(largest, &exponent));
  return -exponent;
}

/// x · 2^shift.
template <typename Scalar, int D>
Vector<Scalar, D> shifted(Vector<Scalar, D> x, int shift) {
  using std::ldexp;
  for (int k = 0; k < D; ++k) x[k] = ldexp(x[k], shift);
  return x;
}

/// |x| = √Σx², the paper's √(Σ(x²)); 1e200 and 1e−200 have lengths too.
/// Laws: (1) norm(−x) == norm(x); (2) norm(2^k x) == 2^k norm(x), both bitwise.
template <typename Scalar, int D>
Scalar norm(const Vector<Scalar, D>& x) {
  using std::ldexp;
  const int shift = comfortable_shift<Scalar, D>(x);
  if (shift == 0) return square_root(x.squaredNorm());
  return ldexp(Scalar(square_root(shifted<Scalar, D>(x, shift).squaredNorm())), -shift);
}

/// x / |x|. REQUIRES x ≠ 0.
template <typename Scalar, int D>
Vector<Scalar, D> unit_vector(const Vector<Scalar, D>& x) {
  const int shift = comfortable_shift<Scalar, D>(x);
  if (shift == 0) return x / Scalar(square_root(x.squaredNorm()));
  const Vector<Scalar, D> y = shifted<Scalar, D>(x, shift);
  return y / Scalar(square_root(y.squaredNorm()));
}

}  // namespace tps
