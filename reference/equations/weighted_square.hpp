// m |x|² and |x|²/m where the square alone would leave the range of the scalar, as that of a blow in SI units
// does in float; m itself is inside it by a factor of 4. docs/engine.md, "Range".
#pragma once

#include "reference/equations/vector.hpp"

namespace tps {

/// m |x|², twice an energy: the bits of m * x.squaredNorm() where that is in a comfortable range. m < ∞.
template <typename Scalar, int D>
Scalar weighted_square(const Scalar& m, const Vector<Scalar, D>& x) {
  using std::ldexp;
  const int shift = comfortable_shift<Scalar, D>(x);
  if (shift == 0) return m * x.squaredNorm();
  return ldexp(Scalar(m * shifted<Scalar, D>(x, shift).squaredNorm()), -2 * shift);
}

/// |x|²/m, of an impulse x twice the energy that it gives a mass m at rest. REQUIRES m > 0; 0 for m = ∞.
template <typename Scalar, int D>
Scalar square_over(const Vector<Scalar, D>& x, const Scalar& m) {
  using std::ldexp;
  const int shift = comfortable_shift<Scalar, D>(x);
  if (shift == 0) return x.squaredNorm() / m;
  return ldexp(Scalar(shifted<Scalar, D>(x, shift).squaredNorm() / m), -2 * shift);
}

}  // namespace tps
