// Exact sums and products of stored numbers: integers times powers of two. docs/engine.md.
#pragma once

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>
#include <type_traits>

namespace tps {

/// digits · 2^exponent. Every finite number of a binary scalar is one; sums, differences and products of
/// them are exact, whatever their range.
struct Dyadic {
  boost::multiprecision::cpp_int digits;
  long exponent = 0;

  int sign() const { return digits.sign(); }

  friend Dyadic operator+(const Dyadic& a, const Dyadic& b) {
    if (a.sign() == 0) return b;
    if (b.sign() == 0) return a;
    const long lower = std::min(a.exponent, b.exponent);
    return {a.digits_at(lower) + b.digits_at(lower), lower};
  }
  friend Dyadic operator-(const Dyadic& a) { return {-a.digits, a.exponent}; }
  friend Dyadic operator-(const Dyadic& a, const Dyadic& b) { return a + -b; }
  friend Dyadic operator*(const Dyadic& a, const Dyadic& b) {
    return {a.digits * b.digits, a.exponent + b.exponent};
  }

  /// The same number's digits at an exponent that is not above its own.
  boost::multiprecision::cpp_int digits_at(long lower) const {
    return digits << static_cast<unsigned long>(exponent - lower);
  }
};

/// The exact value of a stored number. REQUIRES x finite.
template <typename Scalar>
Dyadic dyadic(const Scalar& x) {
  using std::frexp;
  using std::ldexp;
  constexpr int digits = std::numeric_limits<Scalar>::digits;
  int exponent = 0;
  const Scalar fraction = frexp(x, &exponent);
  return {static_cast<boost::multiprecision::cpp_int>(Scalar(ldexp(fraction, digits))), exponent - digits};
}

enum class Rounding { down, up };

/// The number of the scalar that is nearest to a/b from below (`down`) or from above (`up`): a/b itself where
/// that is one, at the smallest steps that the scalar has where a/b is tiny, and beyond its range ±∞.
/// REQUIRES b ≠ 0.
template <typename Scalar>
Scalar rounded_quotient(const Dyadic& a, const Dyadic& b, Rounding rounding) {
  using boost::multiprecision::cpp_int;
  using std::ldexp;
  using Limits = std::numeric_limits<Scalar>;
  if (a.sign() == 0) return Scalar(0);
  const bool negative = (a.sign() < 0) != (b.sign() < 0);
  const cpp_int dividend = abs(a.digits);
  const cpp_int divisor = abs(b.digits);
  const long size = static_cast<long>(msb(dividend)) - static_cast<long>(msb(divisor));  // of the quotient
  const long shift = a.exponent - b.exponent;
  const long least = static_cast<long>(Limits::min_exponent) - Limits::digits;  // of the smallest step
  // |a/b| is in (2^(size−1), 2^(size+1)) · 2^shift: at this exponent it has digits or digits + 1 bits.
  long exponent = std::max(size + shift - Limits::digits, least);
  cpp_int quotient, rest;
  for (;; ++exponent) {
    const long lift = shift - exponent;
    const cpp_int numerator = lift > 0 ? cpp_int(dividend << static_cast<unsigned long>(lift)) : dividend;
    const cpp_int denominator = lift < 0 ? cpp_int(divisor << static_cast<unsigned long>(-lift)) : divisor;
    divide_qr(numerator, denominator, quotient, rest);
    if (quotient == 0 || static_cast<long>(msb(quotient)) < Limits::digits) break;
  }
  if (rest != 0 && negative == (rounding == Rounding::down)) ++quotient;
  const Scalar magnitude = ldexp(static_cast<Scalar>(quotient), static_cast<int>(exponent));
  return negative ? Scalar(-magnitude) : magnitude;
}

/// The number of the scalar nearest to a; of two, the one whose last digit is even. REQUIRES that a is in its
/// range, and a multiple of its smallest number.
template <typename Scalar>
Scalar nearest(const Dyadic& a) {
  const Dyadic one{1, 0};
  const Scalar down = rounded_quotient<Scalar>(a, one, Rounding::down);
  const Scalar up = rounded_quotient<Scalar>(a, one, Rounding::up);
  if (down == up) return down;
  const int side = ((a - dyadic(down)) - (dyadic(up) - a)).sign();
  if (side != 0) return side < 0 ? down : up;
  return bit_test(abs(dyadic(down).digits), 0) ? up : down;
}

/// The next number of the scalar upwards or downwards. REQUIRES x finite.
template <typename Scalar>
Scalar next_number(const Scalar& x, Rounding rounding) {
  using std::frexp;
  using std::ldexp;
  using Limits = std::numeric_limits<Scalar>;
  const bool up = rounding == Rounding::up;
  if constexpr (std::is_floating_point_v<Scalar>) {
    return std::nextafter(x, up ? Limits::infinity() : -Limits::infinity());
  } else {
    if (x == Scalar(0)) return up ? (Limits::min)() : Scalar(-(Limits::min)());
    int exponent = 0;
    const Scalar fraction = frexp(x, &exponent);
    const bool to_smaller_steps = fraction == (up ? Scalar(-0.5) : Scalar(0.5));  // numbers lie closer there
    const Scalar step = ldexp(Scalar(1), exponent - Limits::digits - (to_smaller_steps ? 1 : 0));
    return up ? Scalar(x + step) : Scalar(x - step);
  }
}

}  // namespace tps
