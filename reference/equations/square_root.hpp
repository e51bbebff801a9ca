// The square root of any scalar, rounded once. docs/decisions.md, N198.
#pragma once

#include <cmath>

namespace tps {

/// How a scalar takes its root; numbers of software have a way of their own (wide_square_root.hpp).
template <typename Scalar>
struct SquareRoot {
  static Scalar of(const Scalar& x) {
    using std::sqrt;
    return sqrt(x);
  }
};

/// √x. Laws: (1) the number of the scalar that is nearest to the root of x, as IEEE 754 has it; (2) ±0, +∞,
/// NaN and negative numbers give what sqrt gives.
template <typename Scalar>
Scalar square_root(const Scalar& x) {
  return SquareRoot<Scalar>::of(x);
}

}  // namespace tps
