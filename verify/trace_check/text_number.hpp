// Hexadecimal floats of a trace as the check's numbers.
#pragma once

#include <cmath>
#include <optional>
#include <string_view>

#include "reference/text/hexfloat.hpp"
#include "reference/text/number_text.hpp"
#include "verify/trace_check/exact_sum.hpp"
#include "verify/trace_check/number.hpp"

namespace tps::check {

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

/// The number of the first digits that a sum of two Numbers can have, as a sum.
template <typename Number>
Instant<Number> instant_of(const HexDigits& digits, double start_time) {
  using std::ldexp;
  Number value(0);
  const std::size_t kept = std::min<std::size_t>(digits.digits.size(), 200);
  for (std::size_t n = 0; n < kept; ++n) {
    const char digit = digits.digits[n];
    value = ldexp(value, 4) + Number(digit <= '9' ? digit - '0' : digit - 'a' + 10);
  }
  const long exponent = digits.exponent + 4 * static_cast<long>(digits.digits.size() - kept);
  value = ldexp(value, static_cast<int>(exponent));
  return {(digits.negative ? Number(-value) : value) - Number(start_time), Number(0)};
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
