// m |x|² and |x|²/m, in the range of the scalar wherever the results are: a square alone may leave it, as
// that of a blow in SI units does in float. docs/engine.md, "Range".
#pragma once

#include "reference/equations/vector.hpp"

namespace tps {

/// m |x|², twice an energy. The bits of m * x.squaredNorm() where that square is in a comfortable range.
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
