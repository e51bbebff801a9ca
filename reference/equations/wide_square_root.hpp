// The square root of Boost's binary floats. Their own goes bit by bit, which was four fifths of the time of a
// run in 50 digits; this is Newton's iteration and an exact look at the last bit: the same numbers.
// docs/decisions.md, N198.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <limits>

#include "reference/equations/square_root.hpp"

namespace tps {
namespace detail {

/// Numbers of twice as many bits, which hold the square of one exactly.
template <typename Number>
using TwiceAsWide = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<2 * std::numeric_limits<Number>::digits + 4,
                                         boost::multiprecision::digit_base_2>,
    boost::multiprecision::et_off>;

/// Of m in [1/4, 1), so that y is in [1/2, 1) and its steps are 2^-digits.
template <typename Number>
Number square_root_of_fraction(const Number& m) {
  using Exact = TwiceAsWide<Number>;
  constexpr int digits = std::numeric_limits<Number>::digits;
  // r → 1/√m, its error relative to it squared at each step; then y = m r, and Newton's step for y.
  Number r = 1 / std::sqrt(static_cast<double>(m));
  for (int bits = 50; bits < digits / 2; bits *= 2) r += ldexp(Number(r * (1 - m * r * r)), -1);
  Number y = m * r;
  y += ldexp(Number((m - y * y) * r), -1);
  // y is the nearest number if |√m − y| < step/2: if |m − y² − step²/4| < y step. No root lies in the middle
  // of two numbers, whose squares have more bits than a number has.
  const Number step = ldexp(Number(1), -digits);
  const Exact quarter = ldexp(Exact(1), -2 * digits - 2);
  for (;;) {
    const Exact root(y);
    const Exact off = Exact(m) - root * root - quarter;
    const Exact width = ldexp(root, -digits);
    if (off > width) {
      y += step;
    } else if (off < -width) {
      y -= step;
    } else {
      return y;
    }
  }
}

}  // namespace detail

/// Laws of square_root.
template <unsigned Digits, boost::multiprecision::backends::digit_base_type Base, typename Allocator,
          typename Exponent, Exponent Least, Exponent Most>
struct SquareRoot<boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<Digits, Base, Allocator, Exponent, Least, Most>,
    boost::multiprecision::et_off>> {
  using Number = boost::multiprecision::number<
      boost::multiprecision::cpp_bin_float<Digits, Base, Allocator, Exponent, Least, Most>,
      boost::multiprecision::et_off>;

  static Number of(const Number& x) {
    if (!(x > 0) || !isfinite(x)) return sqrt(x);
    int exponent = 0;
    Number m = frexp(x, &exponent);
    if (exponent % 2 != 0) {
      m = ldexp(m, -1);
      ++exponent;
    }
    return ldexp(detail::square_root_of_fraction(m), exponent / 2);
  }
};

}  // namespace tps
