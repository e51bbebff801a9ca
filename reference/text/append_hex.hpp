// Hexadecimal floats at the end of a line that is being put together: the road of traces, which are nearly
// all such numbers (docs/performance.md, "Traces").
#pragma once

#include <array>
#include <cstddef>
#include <string>

#include "reference/text/hexfloat.hpp"

namespace tps {

/// Bytes that write_hex may touch.
inline constexpr std::size_t kLongestHex = 32;
/// Writes to_hex(x). @return behind its end
char* write_hex(char* to, double x);

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
/// Bytes that write_hex_sum may touch.
inline constexpr std::size_t kLongestHexSum = 48;
/// Writes the same where two words hold its digits, as of nearly all times. @return behind its end; null, and
/// nothing written, elsewhere
char* write_hex_sum(char* to, double hi, double lo);
inline void append_hex_sum(std::string& text, float hi, float lo) {
  append_hex_sum(text, static_cast<double>(hi), static_cast<double>(lo));
}

}  // namespace tps
