// Hexadecimal floats at the end of a line that is being put together: the road of traces, which are nearly
// all such numbers (docs/performance.md, "Traces").
#pragma once

#include <array>
#include <charconv>
#include <concepts>
#include <string>

#include "reference/text/hexfloat.hpp"

namespace tps {

/// Appends to_hex(x).
template <typename Scalar>
void append_hex(std::string& text, const Scalar& x) {
  text.append(to_hex(x));
}
void append_hex(std::string& text, double x);
/// A float has the spelling of the same number in double.
inline void append_hex(std::string& text, float x) {
  append_hex(text, static_cast<double>(x));
}

/// Appends the exact sum of two finite numbers, join_hex(exact_sum({hi, lo})).
template <typename Scalar>
void append_hex_sum(std::string& text, const Scalar& hi, const Scalar& lo) {
  const std::array<HexDigits, 2> terms = {hex_digits(hi), hex_digits(lo)};
  text.append(join_hex(exact_sum(terms)));
}
void append_hex_sum(std::string& text, double hi, double lo);
inline void append_hex_sum(std::string& text, float hi, float lo) {
  append_hex_sum(text, static_cast<double>(hi), static_cast<double>(lo));
}

/// Appends an integer in decimal.
void append_decimal(std::string& text, std::integral auto n) {
  std::array<char, 24> digits;  // 2^64 has 20, and a sign
  text.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), n).ptr);
}

}  // namespace tps
