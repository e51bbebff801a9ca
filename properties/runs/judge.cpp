#include "properties/runs/judge.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>

#include "reference/text/hexfloat.hpp"

namespace tps::properties::runs {
namespace {

constexpr std::size_t kDigitsOfAPart = std::numeric_limits<Real>::digits / 4;

std::uint64_t digit_value(char digit) {
  return static_cast<std::uint64_t>(digit <= '9' ? digit - '0' : digit - 'a' + 10);
}

/// What is missing from digits to a one before the first of them. REQUIRES that the last one is not 0.
std::string complement(std::string digits) {
  for (char& digit : digits) digit = "0123456789abcdef"[15 - digit_value(digit)];
  digits.back() = "123456789abcdef"[digit_value(digits.back())];
  return digits;
}

/// The first digits of a number, rounded to the nearest Real, and what is left.
struct Parted {
  Real leading;
  HexDigits rest;
};

Parted parted(const HexDigits& number) {
  const std::string& digits = number.digits;
  const std::size_t taken = std::min(digits.size(), kDigitsOfAPart);
  std::uint64_t value = 0;
  for (const char digit : std::string_view(digits).substr(0, taken)) value = value << 4 | digit_value(digit);
  Parted parts{Real(value), {number.negative, digits.substr(taken), number.exponent}};
  if (taken < digits.size() && digits[taken] >= '8') {
    parts.leading += 1;
    parts.rest.digits = complement(parts.rest.digits);
    parts.rest.negative = !number.negative;
  }
  parts.rest.digits.erase(0, parts.rest.digits.find_first_not_of('0'));
  const long places = 4 * static_cast<long>(digits.size() - taken);
  parts.leading = std::ldexp(parts.leading, static_cast<int>(number.exponent + places));
  if (number.negative) parts.leading = -parts.leading;
  return parts;
}

}  // namespace

Instant read_instant(std::string_view hex) {
  if (hex == "inf") return {std::numeric_limits<Real>::infinity(), 0};
  const std::optional<HexDigits> number = split_hex(hex);
  if (!number) throw std::invalid_argument("'" + std::string(hex) + "' is no hexadecimal float");
  const Parted first = parted(*number);
  return {first.leading, first.rest.digits.empty() ? 0 : parted(first.rest).leading};
}

Real read_real(std::string_view hex) {
  const Instant parts = read_instant(hex);
  return parts.hi + parts.lo;
}

Real judged_roundoff(std::string_view scalar) {
  if (scalar == "float") return std::ldexp(Real(1), -24);
  if (scalar == "double") return std::ldexp(Real(1), -53);
  return std::ldexp(Real(1), -58);
}

}  // namespace tps::properties::runs
