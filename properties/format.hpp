// The numbers that an implementation computes with, as far as cases must know them.
#pragma once

#include <algorithm>
#include <cmath>

namespace tps::properties {

/// Binary numbers of `bits` significant bits. A law's bound is in units of 2^-bits, the unit roundoff; the
/// numbers of its cases are doubles that the format holds.
struct Format {
  int bits = 53;
  int max_exponent = 1023;

  static Format of_bits(int bits) { return {bits, bits <= 24 ? 127 : bits <= 53 ? 1023 : 16383}; }

  /// Exponents of the numbers in cases: ± this. A product of six of them, and its rounding errors, stay
  /// within the format.
  int largest_case_exponent() const { return std::min(max_exponent, 1023) / 17; }

  /// The nearest number of the format. REQUIRES |x| within its range.
  double rounded(double x) const {
    if (bits >= 53 || x == 0 || !std::isfinite(x)) return x;
    int exponent = 0;
    const double fraction = std::frexp(x, &exponent);
    return std::ldexp(std::nearbyint(std::ldexp(fraction, bits)), exponent - bits);
  }
};

}  // namespace tps::properties
