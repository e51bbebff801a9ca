#include "properties/runs/judge.hpp"

#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>

#include "reference/text/hexfloat.hpp"

namespace tps::properties::runs {
namespace {

constexpr std::size_t kDigitsOfAPart = std::numeric_limits<Real>::digits / 4;

/// The Real nearest to a number by its first 64 bits and the digit behind them.
Real leading_part(const HexDigits& number) {
  const std::string_view digits = std::string_view(number.digits).substr(0, kDigitsOfAPart);
  Real value = 0;
  for (const char digit : digits) value = value * 16 + Real(digit <= '9' ? digit - '0' : digit - 'a' + 10);
  const std::size_t behind = number.digits.size() - digits.size();
  if (behind > 0 && number.digits[digits.size()] >= '8') value += 1;
  const Real size = std::ldexp(value, static_cast<int>(number.exponent + 4 * static_cast<long>(behind)));
  return number.negative ? -size : size;
}

}  // namespace

Instant read_instant(std::string_view hex) {
  if (hex == "inf") return {std::numeric_limits<Real>::infinity(), 0};
  const std::optional<HexDigits> number = split_hex(hex);
  if (!number) throw std::invalid_argument("'" + std::string(hex) + "' is no hexadecimal float");
  const Real hi = leading_part(*number);
  const HexDigits terms[] = {*number, hex_digits(-hi)};
  return {hi, leading_part(exact_sum(terms))};
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
