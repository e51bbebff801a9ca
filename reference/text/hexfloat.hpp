// Hexadecimal floats: the exact, portable spelling of a binary number of any precision, "-0x1.8p+1".
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tps {

/// The parts of [sign] 0x hexdigits [. hexdigits] p [sign] digits: the one spelling of a hexadecimal float
/// that anything reads. At least one hexadecimal digit stands before or behind the point.
struct HexSpelling {
  bool negative = false;
  std::string_view whole, fraction;  ///< hexadecimal digits before and behind the point, lower or upper case
  std::int64_t exponent = 0;         ///< behind the p; beyond ±2^60 it is that
};

/// The parts of the whole of `text`; nothing where it is spelt in any other way, "inf" included.
std::optional<HexSpelling> hex_spelling(std::string_view text);

/// The value of a hexadecimal digit of either case, −1 for any other character.
constexpr int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

/// A finite binary number without a width: sign · 0x digits · 2^exponent.
struct HexDigits {
  bool negative = false;
  std::string digits;  ///< hexadecimal, most significant first, no leading or trailing zero; empty for zero
  long exponent = 0;   ///< of the last digit: value = (digits as an integer) · 2^exponent
};

/// The digits of a hexadecimal float (hex_spelling); nothing for any other text, nor for exponents beyond
/// ±2^20: no run comes near them, and an exact sum of such numbers would have a million digits.
std::optional<HexDigits> split_hex(std::string_view text);

/// The normalised spelling: leading digit 1, no trailing zeros, "0x0p+0" for zero.
std::string join_hex(const HexDigits& digits);

/// The exact sum of numbers, as digits: no rounding, whatever their exponents.
HexDigits exact_sum(std::span<const HexDigits> terms);

/// Bits from the first to the last one set.
int significant_bits(const HexDigits& digits);

/// The digits of a finite number of any binary scalar type.
template <typename Scalar>
HexDigits hex_digits(const Scalar& x) {
  using std::abs;
  using std::frexp;
  using std::ldexp;
  using std::signbit;
  HexDigits result;
  result.negative = signbit(x) != 0;
  if (x == Scalar(0)) return result;
  int exponent = 0;
  Scalar fraction = ldexp(frexp(Scalar(abs(x)), &exponent), 1);  // in [1, 2)
  result.exponent = exponent - 1;
  while (true) {
    const int digit = static_cast<int>(fraction);
    result.digits.push_back("0123456789abcdef"[digit]);
    fraction -= Scalar(digit);
    if (fraction == Scalar(0)) break;
    fraction = ldexp(fraction, 4);
    result.exponent -= 4;
  }
  return result;
}

/// The shortest exact hexadecimal spelling of a number, "inf" or "-inf" for the infinities.
/// REQUIRES not NaN. Law: from_hex<Scalar>(to_hex(x)) == x.
template <typename Scalar>
std::string to_hex(const Scalar& x) {
  if (x == std::numeric_limits<Scalar>::infinity()) return "inf";
  if (x == -std::numeric_limits<Scalar>::infinity()) return "-inf";
  return join_hex(hex_digits(x));
}

/// The faster road for the type that most traces are written in (append_hex.hpp).
template <>
std::string to_hex<double>(const double& x);

/// The number that a hexadecimal float (or "inf", "-inf") spells; nothing when the text is malformed or
/// the scalar cannot hold it exactly.
template <typename Scalar>
std::optional<Scalar> from_hex(std::string_view text) {
  using std::frexp;
  using std::ldexp;
  using Limits = std::numeric_limits<Scalar>;
  if (text == "inf") return Limits::infinity();
  if (text == "-inf") return -Limits::infinity();
  const std::optional<HexDigits> hex = split_hex(text);
  if (!hex) return std::nullopt;
  if (significant_bits(*hex) > Limits::digits) return std::nullopt;
  constexpr long kFarthest = std::numeric_limits<int>::max() / 2;
  if (hex->exponent > kFarthest || hex->exponent < -kFarthest) return std::nullopt;
  Scalar value(0);
  for (const char digit : hex->digits) {
    value = ldexp(value, 4) + Scalar(digit <= '9' ? digit - '0' : digit - 'a' + 10);
  }
  const Scalar magnitude = ldexp(value, static_cast<int>(hex->exponent));
  if (magnitude > (Limits::max)()) return std::nullopt;
  const Scalar signed_value = hex->negative ? Scalar(-magnitude) : magnitude;
  if (join_hex(hex_digits(signed_value)) != join_hex(*hex)) return std::nullopt;  // lost in underflow
  return signed_value;
}

}  // namespace tps
