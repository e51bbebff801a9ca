#include "verify/exact/exact_root.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tps::exact {
namespace {

Integer magnitude(const Integer& x) {
  return x < 0 ? Integer(-x) : x;
}

int bits(const Integer& x) {
  return x == 0 ? 0 : static_cast<int>(msb(magnitude(x))) + 1;
}

/// ⌊x 2^k⌋ for x ≥ 0, k of any sign.
Integer shifted(const Integer& x, int k) {
  return k >= 0 ? Integer(x << static_cast<unsigned>(k)) : Integer(x >> static_cast<unsigned>(-k));
}

/// The sign of t − n 2^-k: the quadratic's sign at the point, and on which side of closest approach it lies.
Sign compared(const AlgebraicTime& time, const Integer& n, int k) {
  // With everything times 2^k: the distance a·x + h of the point x = n 2^-k from closest approach, times a.
  const int up = std::max(k, 0);
  const int down = std::max(-k, 0);
  const Integer h = time.h * shifted(1, up);
  const Integer distance = shifted(time.a * n, down) + h;
  if (time.side == 0 || distance == 0) {
    // t − x = (side √D·2^k − distance) / a, and one of the two terms is absent.
    if (time.side == 0 || time.D == 0) return sign_of(-distance);
    return time.side > 0 ? Sign::positive : Sign::negative;
  }
  const bool beyond = distance > 0;  // x lies after closest approach
  if (beyond != (time.side > 0)) return time.side > 0 ? Sign::positive : Sign::negative;
  // Same side: the farther from closest approach, the larger |distance|; compare D 4^k with distance².
  const Integer difference = shifted(time.D, 2 * up) - distance * distance;
  return sign_of(time.side > 0 ? difference : Integer(-difference));
}

/// Whether −h and side √D have one sign, so that their sum does not cancel.
bool adds(const AlgebraicTime& time) {
  return time.side == 0 || (time.side > 0) == (time.h <= 0);
}

/// Bits of the larger of |h| and √D.
int sum_bits(const AlgebraicTime& time) {
  return std::max(bits(time.h), (bits(time.D) + 1) / 2);
}

/// About t 2^k with a relative error below 2^-70, then rounded down.
Integer estimate(const AlgebraicTime& time, const Integer& c, int k) {
  const int guard = std::max(0, 72 - bits(time.D) / 2);
  const Integer root = sqrt(shifted(time.D, 2 * guard));  // √D 2^guard
  const Integer sum = shifted(magnitude(time.h), guard) + root;
  if (adds(time)) {
    const int shift = k - guard;  // (|h| + √D) / a
    return shift >= 0 ? Integer(shifted(sum, shift) / time.a) : Integer(sum / shifted(time.a, -shift));
  }
  const int shift = k + guard;  // |c| / (|h| + √D)
  return shift >= 0 ? Integer(shifted(magnitude(c), shift) / sum)
                    : Integer(magnitude(c) / shifted(sum, -shift));
}

/// ⌊t 2^k⌋, proved by signs on both sides.
Integer floor_of(const AlgebraicTime& time, const Integer& c, int k) {
  Integer n = estimate(time, c, k);
  while (compared(time, n, k) == Sign::negative) --n;
  while (compared(time, n + 1, k) != Sign::negative) ++n;
  return n;
}

/// n 2^-k with n rounded to its last bit but one. REQUIRES 0 ≤ n < 2^54.
double rounded_half(const Integer& n, bool exact, int k) {
  const auto halves = static_cast<std::uint64_t>(n);
  const std::uint64_t units = halves / 2;
  const bool above_half = halves % 2 != 0 && !exact;
  const bool tie = halves % 2 != 0 && exact;
  const std::uint64_t nearest = units + (above_half || (tie && units % 2 != 0) ? 1U : 0U);
  return std::ldexp(static_cast<double>(nearest), 1 - k);
}

}  // namespace

AlgebraicTime algebraic_time(Kind kind, Verdict verdict, const LiftedQuadratic& quadratic) {
  if (at_once(verdict)) return {1, 0, 0, 0, quadratic.time_exponent};
  const int side = verdict == Verdict::turning ? 0 : kind == Kind::block ? -1 : 1;
  return {quadratic.a, quadratic.h, side == 0 ? Integer(0) : quadratic.D, side, quadratic.time_exponent};
}

double rounded(const AlgebraicTime& time, const Integer& c) {
  if (time.side == 0 && time.h == 0) return 0;
  // First with 62 to 66 bits to see the exponent, then with 54, or ending at half of the smallest subnormal.
  int k = 64 + (adds(time) ? bits(time.a) - sum_bits(time) : sum_bits(time) - bits(c));
  k -= bits(estimate(time, c, k)) - 54;
  k = std::min(k, 1075 + time.time_exponent);
  if (53 - k + time.time_exponent >= 1024 + 1) return std::numeric_limits<double>::infinity();
  Integer n = floor_of(time, c, k);
  if (bits(n) > 54) n = floor_of(time, c, --k);
  const bool exact = compared(time, n, k) == Sign::zero;
  return rounded_half(n, exact, k - time.time_exponent);
}

}  // namespace tps::exact
