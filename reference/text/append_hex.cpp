#include "reference/text/append_hex.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

namespace tps {
namespace {

constexpr int kFractionBits = 52;
constexpr int kBias = 1023;

/// The eight hexadecimal digits of a word, most significant first, as the bytes of their text: nibbles are
/// spread to bytes, and those above 9 move on to the letters.
std::array<char, 8> digits_of(std::uint32_t word) {
  std::uint64_t x = word;
  x = (x | (x << 16U)) & 0x0000ffff0000ffffU;
  x = (x | (x << 8U)) & 0x00ff00ff00ff00ffU;
  x = (x | (x << 4U)) & 0x0f0f0f0f0f0f0f0fU;
  const std::uint64_t above_nine = ((x + 0x0606060606060606U) >> 4U) & 0x0101010101010101U;
  x += 0x3030303030303030U + above_nine * ('a' - '0' - 10);
  if constexpr (std::endian::native == std::endian::little) x = __builtin_bswap64(x);
  return std::bit_cast<std::array<char, 8>>(x);
}

/// Writes ".…" with the digits of 4·16 bits, high word first, without trailing zeros; nothing for zero.
char* put_fraction(char* out, std::uint64_t high, std::uint64_t low) {
  if (high == 0 && low == 0) return out;
  *out++ = '.';
  const int zeros = low != 0 ? std::countr_zero(low) : 64 + std::countr_zero(high);
  const int count = 32 - zeros / 4;
  char* to = out;
  for (const std::uint64_t word : {high, low}) {
    for (const unsigned shift : {32U, 0U}) {
      if (to >= out + count) break;
      const std::array<char, 8> eight = digits_of(static_cast<std::uint32_t>(word >> shift));
      std::memcpy(to, eight.data(), eight.size());
      to += eight.size();
    }
  }
  return out + count;
}

/// Appends ±1.fraction · 2^exponent, the fraction being that of 128 bits.
void append_number(std::string& text, bool negative, std::uint64_t high, std::uint64_t low, int exponent) {
  std::array<char, 48> buffer;  // -0x1. and 32 digits, p±9999
  char* out = buffer.data();
  if (negative) *out++ = '-';
  *out++ = '0';
  *out++ = 'x';
  *out++ = '1';
  out = put_fraction(out, high, low);
  *out++ = 'p';
  *out++ = exponent < 0 ? '-' : '+';
  out = std::to_chars(out, buffer.data() + buffer.size(), std::abs(exponent)).ptr;
  text.append(buffer.data(), out);
}

struct Parts {
  bool negative;
  int exponent;            ///< of the leading bit
  std::uint64_t fraction;  ///< 52 bits behind the leading one
};

bool is_normal(double x) {
  const std::uint64_t exponent = (std::bit_cast<std::uint64_t>(x) >> kFractionBits) & 0x7ffU;
  return exponent != 0 && exponent != 0x7ffU;
}

/// REQUIRES a normal number.
Parts parts_of(double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  return {(bits >> 63U) != 0, static_cast<int>((bits >> kFractionBits) & 0x7ffU) - kBias,
          bits & ((std::uint64_t{1} << kFractionBits) - 1)};
}

}  // namespace

void append_hex(std::string& text, double x) {
  if (!is_normal(x)) {
    if (std::isinf(x)) {
      text.append(x > 0 ? "inf" : "-inf");
    } else {
      text.append(join_hex(hex_digits(x)));
    }
    return;
  }
  const Parts p = parts_of(x);
  append_number(text, p.negative, p.fraction << (64 - kFractionBits), 0, p.exponent);
}

template <>
std::string to_hex<double>(const double& x) {
  std::string text;
  append_hex(text, x);
  return text;
}

void append_hex_sum(std::string& text, double hi, double lo) {
  if (lo == 0 && hi != 0) return append_hex(text, hi);
  // hi is an integer of 53 bits in units of its last one, 64 bits behind it hold lo, if it ends there.
  const double head = hi + lo;
  const double rest = lo - (head - hi);
  const bool is_pair = head == hi && rest == lo && is_normal(hi) && hi > 0 && is_normal(lo);
  const int unit = is_pair ? parts_of(hi).exponent - kFractionBits : 0;
  const double scaled = is_pair ? std::ldexp(lo, 64 - unit) : 0;
  if (scaled == 0 || std::abs(scaled) > 0x1p63 || scaled != std::trunc(scaled)) {
    append_hex_sum<double>(text, hi, lo);
    return;
  }
  const Parts p = parts_of(hi);
  std::uint64_t high = p.fraction | (std::uint64_t{1} << kFractionBits);
  const auto magnitude = static_cast<std::uint64_t>(std::abs(scaled));
  std::uint64_t low = scaled < 0 ? 0 - magnitude : magnitude;
  if (scaled < 0) --high;
  const int shift = std::countl_zero(high) + 1;  // drops the leading bit
  const std::uint64_t top = high << static_cast<unsigned>(shift) | low >> static_cast<unsigned>(64 - shift);
  append_number(text, false, top, low << static_cast<unsigned>(shift), unit + 64 - shift);
}

}  // namespace tps
