// Hexadecimal floats of a trace as the check's numbers.
#pragma once

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "reference/text/hexfloat.hpp"
#include "reference/text/number_text.hpp"
#include "verify/trace_check/exact_sum.hpp"
#include "verify/trace_check/number.hpp"

namespace tps::check {

/// Hexadecimal digits of a time that are read: more than lie between the largest double and the last bit of
/// hi + lo beside the smallest.
inline constexpr std::size_t kDigitsOfATime = 1500;

/// The number that a text spells, or nothing where it is no number of that width. Infinities are numbers
/// here.
template <typename Number>
std::optional<Number> number_of(std::string_view text) {
  return from_hex<Number>(text);
}
template <>
inline std::optional<double> number_of<double>(std::string_view text) {
  if (text == "inf") return HUGE_VAL;
  const HexFloat hex = parse_hex_float(text);
  if (hex.verdict != HexFloat::Verdict::exact) return std::nullopt;
  return hex.value;
}

/// The number that a time on the scene's clock is after start_time. The difference is formed exactly: beside
/// a late start a sum hi + lo has more digits than a Number.
template <typename Number>
Instant<Number> instant_of(const HexDigits& digits, double start_time) {
  using boost::multiprecision::cpp_int;
  using std::ldexp;
  const std::size_t kept = std::min(digits.digits.size(), kDigitsOfATime);
  cpp_int value = kept == 0 ? cpp_int(0) : cpp_int("0x" + std::string(digits.digits.substr(0, kept)));
  if (digits.negative) value = -value;
  long exponent = digits.exponent + 4 * static_cast<long>(digits.digits.size() - kept);
  if (start_time != 0) {
    constexpr int kBits = std::numeric_limits<double>::digits;
    int start_exponent = 0;
    cpp_int start(ldexp(std::frexp(start_time, &start_exponent), kBits));
    start_exponent -= kBits;
    const long lowest = std::min<long>(exponent, start_exponent);
    value = (value << static_cast<unsigned>(exponent - lowest)) -
            (start << static_cast<unsigned>(start_exponent - lowest));
    exponent = lowest;
  }
  return {ldexp(Number(value), static_cast<int>(exponent)), Number(0)};
}

/// Pieces of 52 bits are doubles. Their sum with −start_time is one of two doubles, but not every partial sum
/// on the way there is: 0.1 off a long time leaves more bits than two doubles hold until its last piece has
/// come.
template <>
inline Instant<double> instant_of(const HexDigits& digits, double start_time) {
  ExactSum sum;
  sum.add(-start_time);
  constexpr long kPiece = 13;
  const auto length = static_cast<long>(digits.digits.size());
  for (long begin = 0; begin < length; begin += kPiece) {
    double piece = 0;
    const long end = std::min(begin + kPiece, length);
    for (long n = begin; n < end; ++n) {
      const char digit = digits.digits[static_cast<std::size_t>(n)];
      piece = piece * 16 + (digit <= '9' ? digit - '0' : digit - 'a' + 10);
    }
    piece = std::ldexp(piece, static_cast<int>(digits.exponent + 4 * (length - end)));
    if (std::isinf(piece)) return {digits.negative ? -piece : piece, 0};
    sum.add(digits.negative ? -piece : piece);
  }
  const double hi = sum.rounded();
  sum.add(-hi);
  return {hi, sum.rounded()};
}

/// A time on the scene's clock as time since the start.
template <typename Number>
std::optional<Instant<Number>> instant_of(std::string_view text, double start_time) {
  if (start_time == 0 && text.size() <= 20) {
    const std::optional<Number> simple = number_of<Number>(text);
    if (simple) return Instant<Number>{*simple, Number(0)};
  }
  const std::optional<HexDigits> digits = split_hex(text);
  constexpr long kFarthest = 1L << 20;
  if (!digits || digits->exponent > kFarthest || digits->exponent < -kFarthest) return std::nullopt;
  return instant_of<Number>(*digits, start_time);
}

}  // namespace tps::check
