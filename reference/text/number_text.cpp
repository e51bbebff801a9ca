#include "reference/text/number_text.hpp"

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>

#include "reference/text/hexfloat.hpp"

namespace tps {
namespace {

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
  const std::optional<HexSpelling> spelling = hex_spelling(text);
  if (!spelling) return {};
  std::uint64_t m = 0;
  std::int64_t e = spelling->exponent - 4 * static_cast<std::int64_t>(spelling->fraction.size());
  bool too_long = false;  // a digit that is not zero beyond 61 significant bits: more than a double's 53
  for (const std::string_view digits : {spelling->whole, spelling->fraction}) {
    for (const char c : digits) {
      const auto digit = static_cast<std::uint64_t>(hex_digit(c));
      if (m < (std::uint64_t{1} << 60)) {
        m = 16 * m + digit;
      } else {
        too_long = too_long || digit != 0;
        e += 4;
      }
    }
  }
  if (too_long) return {HexFloat::Verdict::not_a_double, 0};
  return exact_double(m, e, spelling->negative);
}

std::string write_shortest(double value) {
  std::array<char, 40> buffer;
  const std::to_chars_result end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  std::string text(buffer.data(), end.ptr);
  // Many readers of JSON take "-0" for the integer 0 and lose its sign.
  return text == "-0" ? "-0.0" : text;
}

}  // namespace tps
