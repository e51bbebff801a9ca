// Hexadecimal floats of a trace as the check's numbers.
#pragma once

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

#include "reference/equations/dyadic.hpp"
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

/// What a time on the scene's clock is after start_time, exactly.
inline Dyadic since_start(const HexDigits& digits, double start_time) {
  using boost::multiprecision::cpp_int;
  const std::size_t kept = std::min(digits.digits.size(), kDigitsOfATime);
  cpp_int value = kept == 0 ? cpp_int(0) : cpp_int("0x" + std::string(digits.digits.substr(0, kept)));
  if (digits.negative) value = -value;
  const long exponent = digits.exponent + 4 * static_cast<long>(digits.digits.size() - kept);
  return Dyadic{value, exponent} - dyadic(start_time);
}

/// As hi + lo: 2⁻⁸³³ of a time are no rest where it is late and something comes soon after it.
template <typename Number>
Instant<Number> in_two_numbers(const Dyadic& t) {
  using std::ldexp;
  const auto rounded = [](const Dyadic& x) {
    return Number(ldexp(Number(x.digits), static_cast<int>(x.exponent)));
  };
  const Number hi = rounded(t);
  const bool is_one =
      t.sign() == 0 || static_cast<long>(msb(abs(t.digits))) < std::numeric_limits<Number>::digits;
  return {hi, is_one ? Number(0) : rounded(t - dyadic(hi))};
}

/// The time that one on the scene's clock is after start_time. The difference is formed exactly: beside a
/// late start a sum hi + lo has more digits than a Number.
template <typename Number>
Instant<Number> instant_of(const HexDigits& digits, double start_time) {
  return in_two_numbers<Number>(since_start(digits, start_time));
}

/// As hi + lo; infinite beyond the doubles.
inline Instant<double> in_two_doubles(const Dyadic& t) {
  const Dyadic one{1, 0};
  const auto towards_zero = [&](const Dyadic& x) {
    return rounded_quotient<double>(x, one, x.sign() < 0 ? Rounding::up : Rounding::down);
  };
  double hi = towards_zero(t);
  if (std::isinf(hi)) return {hi, 0};
  if (std::fabs(hi) < std::numeric_limits<double>::max()) hi = nearest<double>(t);
  return {hi, towards_zero(t - dyadic(hi))};
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
    if (std::isinf(piece)) return in_two_doubles(since_start(digits, start_time));
    sum.add(digits.negative ? -piece : piece);
  }
  const double hi = sum.rounded();
  sum.add(-hi);
  return {hi, sum.rounded()};
}

/// A time since the start that is spelt "0x1.…p±…" with at most 30 digits behind the point, as a whole number
/// of 124 bits times a power of two: hi is the nearest double, lo that of the rest. Nothing for any other
/// text.
inline std::optional<Instant<double>> usual_time(std::string_view text) {
  constexpr std::size_t kMost = 30;
  constexpr int kFarthest = 900;  // so that neither part leaves the range of normal doubles
  if (!text.starts_with("0x1")) return std::nullopt;
  __extension__ using Wide = unsigned __int128;  // of both compilers; the standard has none
  __extension__ using Signed = __int128;
  Wide whole = 1;
  std::size_t at = 3, digits = 0;
  if (at < text.size() && text[at] == '.') {
    for (++at; at < text.size() && digits <= kMost; ++at, ++digits) {
      const char c = text[at];
      if (c >= '0' && c <= '9') {
        whole = whole << 4U | static_cast<unsigned>(c - '0');
      } else if (c >= 'a' && c <= 'f') {
        whole = whole << 4U | static_cast<unsigned>(c - 'a' + 10);
      } else {
        break;
      }
    }
  }
  if (digits > kMost || at + 2 >= text.size() || text[at] != 'p') return std::nullopt;
  const bool is_below = text[at + 1] == '-';
  if (!is_below && text[at + 1] != '+') return std::nullopt;
  int exponent = 0;
  const auto [end, error] = std::from_chars(text.data() + at + 2, text.data() + text.size(), exponent);
  if (error != std::errc() || end != text.data() + text.size() || exponent < 0 || exponent > kFarthest / 2)
    return std::nullopt;
  const auto hi = static_cast<double>(whole);
  const auto rest = static_cast<Signed>(whole - static_cast<Wide>(hi));
  const double unit = std::ldexp(1.0, (is_below ? -exponent : exponent) - 4 * static_cast<int>(digits));
  return Instant<double>{hi * unit, static_cast<double>(rest) * unit};
}

/// A time on the scene's clock as time since the start.
template <typename Number>
std::optional<Instant<Number>> instant_of(std::string_view text, double start_time) {
  if constexpr (std::is_same_v<Number, double>) {
    if (const auto usual = start_time == 0 ? usual_time(text) : std::nullopt) return usual;
  }
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
