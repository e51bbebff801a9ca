#include "reference/text/number_text.hpp"

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>

namespace tps {
namespace {

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

// Consumes an optional sign; true for '-'.
bool take_sign(std::string_view& text) {
  const bool negative = text.starts_with('-');
  if (negative || text.starts_with('+')) text.remove_prefix(1);
  return negative;
}

// Exponents beyond any double's are all alike; a bound keeps the arithmetic on them from overflowing, and is
// larger than four times the longest text, so that no number of digits can bring one back into range.
constexpr std::int64_t exponent_bound = std::int64_t{1} << 60;

// m 2^e is a double exactly if m, stripped of trailing zeros, has at most 53 bits, its lowest bit is at
// 2^-1074 or above and its highest at 2^1023 or below.
HexFloat exact_double(std::uint64_t m, std::int64_t e, bool negative) {
  if (m == 0) return {HexFloat::Verdict::exact, negative ? -0.0 : 0.0};
  const int zeros = std::countr_zero(m);
  m >>= zeros;
  e += zeros;
  const int bits = 64 - std::countl_zero(m);
  if (bits > 53 || e < -1074 || e + bits > 1024) return {HexFloat::Verdict::not_a_double, 0};
  const double magnitude = std::ldexp(static_cast<double>(m), static_cast<int>(e));
  return {HexFloat::Verdict::exact, negative ? -magnitude : magnitude};
}

}  // namespace

HexFloat parse_hex_float(std::string_view text) {
  const HexFloat malformed;
  const bool negative = take_sign(text);
  if (!text.starts_with("0x") && !text.starts_with("0X")) return malformed;
  text.remove_prefix(2);

  std::uint64_t m = 0;
  std::int64_t e = 0;
  bool any_digit = false;
  bool after_point = false;
  bool too_long = false;  // a nonzero digit beyond 61 significant bits: more than a double's 53
  while (!text.empty() && (hex_digit(text.front()) >= 0 || (text.front() == '.' && !after_point))) {
    const char c = text.front();
    text.remove_prefix(1);
    if (c == '.') {
      after_point = true;
      continue;
    }
    any_digit = true;
    const auto digit = static_cast<std::uint64_t>(hex_digit(c));
    if (m < (std::uint64_t{1} << 60)) {
      m = 16 * m + digit;
      if (after_point) e -= 4;
    } else {
      too_long = too_long || digit != 0;
      if (!after_point) e += 4;
    }
  }
  if (!any_digit || (!text.starts_with('p') && !text.starts_with('P'))) return malformed;
  text.remove_prefix(1);

  const bool negative_exponent = take_sign(text);
  if (text.empty()) return malformed;
  std::int64_t exponent = 0;
  for (const char c : text) {
    if (c < '0' || c > '9') return malformed;
    exponent = exponent < exponent_bound / 16 ? 10 * exponent + (c - '0') : exponent_bound;
  }
  if (too_long) return {HexFloat::Verdict::not_a_double, 0};
  return exact_double(m, e + (negative_exponent ? -exponent : exponent), negative);
}

std::string write_hex_float(double value) {
  if (std::isinf(value)) return value < 0 ? "-inf" : "inf";
  std::array<char, 40> buffer;
  const double magnitude = std::fabs(value);
  const std::to_chars_result end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), magnitude, std::chars_format::hex);
  return (std::signbit(value) ? "-0x" : "0x") + std::string(buffer.data(), end.ptr);
}

std::string write_shortest(double value) {
  std::array<char, 40> buffer;
  const std::to_chars_result end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  std::string text(buffer.data(), end.ptr);
  // Many readers of JSON take "-0" for the integer 0 and lose its sign.
  return text == "-0" ? "-0.0" : text;
}

}  // namespace tps
