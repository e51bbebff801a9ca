#include "properties/runs/judge.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>

#include "reference/text/hexfloat.hpp"

namespace tps::properties::runs {
namespace {

constexpr std::size_t kDigitsOfAPart = std::numeric_limits<Real>::digits / 4;

Real digits_as_number(std::string_view digits, long exponent_of_last) {
  Real value = 0;
  for (const char digit : digits) value = value * 16 + Real(digit <= '9' ? digit - '0' : digit - 'a' + 10);
  return std::ldexp(value, static_cast<int>(exponent_of_last));
}

}  // namespace

Instant read_instant(std::string_view hex) {
  if (hex == "inf") return {std::numeric_limits<Real>::infinity(), 0};
  const std::optional<HexDigits> split = split_hex(hex);
  if (!split) throw std::invalid_argument("'" + std::string(hex) + "' is no hexadecimal float");
  const std::string_view digits = split->digits;
  const std::size_t first = std::min(digits.size(), kDigitsOfAPart);
  const std::size_t second = std::min(digits.size(), 2 * kDigitsOfAPart) - first;
  const auto exponent = [&](std::size_t behind) {
    return split->exponent + 4 * static_cast<long>(digits.size() - behind);
  };
  const Real hi = digits_as_number(digits.substr(0, first), exponent(first));
  const Real lo = digits_as_number(digits.substr(first, second), exponent(first + second));
  return split->negative ? Instant{-hi, -lo} : Instant{hi, lo};
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
