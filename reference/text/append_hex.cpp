#include "reference/text/append_hex.hpp"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>

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

/// Writes ".…" with the digits of 64 bits, most significant first, without trailing zeros; nothing for zero.
/// Up to 17 bytes are touched.
char* put_fraction(char* out, std::uint64_t bits) {
  if (bits == 0) return out;
  *out++ = '.';
  for (const unsigned shift : {32U, 0U}) {
    const std::array<char, 8> eight = digits_of(static_cast<std::uint32_t>(bits >> shift));
    std::memcpy(out + (shift == 0 ? 8 : 0), eight.data(), eight.size());
  }
  return out + 16 - std::countr_zero(bits) / 4;
}

/// The same of 128 bits, high word first.
char* put_fraction(char* out, std::uint64_t high, std::uint64_t low) {
  if (low == 0) return put_fraction(out, high);
  *out++ = '.';
  for (const std::uint64_t word : {high, low}) {
    for (const unsigned shift : {32U, 0U}) {
      const std::array<char, 8> eight = digits_of(static_cast<std::uint32_t>(word >> shift));
      std::memcpy(out, eight.data(), eight.size());
      out += eight.size();
    }
  }
  return out - std::countr_zero(low) / 4;
}

char* put_exponent(char* out, int exponent) {
  *out++ = 'p';
  *out++ = exponent < 0 ? '-' : '+';
  const int size = std::abs(exponent);
  if (size < 10) {
    *out = static_cast<char>('0' + size);
    return out + 1;
  }
  return std::to_chars(out, out + 4, size).ptr;
}

char* put_sign_and_lead(char* out, bool negative) {
  *out = '-';
  out += negative ? 1 : 0;
  std::memcpy(out, "0x1", 3);
  return out + 3;
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

char* write_hex(char* to, double x) {
  if (!is_normal(x)) {
    const std::string spelt = std::isinf(x) ? (x > 0 ? "inf" : "-inf") : join_hex(hex_digits(x));
    return std::copy(spelt.begin(), spelt.end(), to);
  }
  const Parts p = parts_of(x);
  to = put_fraction(put_sign_and_lead(to, p.negative), p.fraction << (64 - kFractionBits));
  return put_exponent(to, p.exponent);
}

void append_hex(std::string& text, double x) {
  std::array<char, kLongestHex> buffer;
  text.append(buffer.data(), write_hex(buffer.data(), x));
}

template <>
std::string to_hex<double>(const double& x) {
  std::string text;
  append_hex(text, x);
  return text;
}

char* write_hex_sum(char* to, double hi, double lo) {
  if (lo == 0 && hi != 0) return write_hex(to, hi);
  // hi is an integer of 53 bits in units of its last one, 64 bits behind it hold lo, if it ends there.
  const double head = hi + lo;
  const double rest = lo - (head - hi);
  const bool is_pair = head == hi && rest == lo && is_normal(hi) && hi > 0 && is_normal(lo);
  const int unit = is_pair ? parts_of(hi).exponent - kFractionBits : 0;
  const double scaled = is_pair ? std::ldexp(lo, 64 - unit) : 0;
  if (scaled == 0 || std::abs(scaled) > 0x1p63 || scaled != std::trunc(scaled)) return nullptr;
  const Parts p = parts_of(hi);
  std::uint64_t high = p.fraction | (std::uint64_t{1} << kFractionBits);
  const auto magnitude = static_cast<std::uint64_t>(std::abs(scaled));
  std::uint64_t low = scaled < 0 ? 0 - magnitude : magnitude;
  if (scaled < 0) --high;
  const int shift = std::countl_zero(high) + 1;  // drops the leading bit
  const std::uint64_t top = high << static_cast<unsigned>(shift) | low >> static_cast<unsigned>(64 - shift);
  to = put_fraction(put_sign_and_lead(to, false), top, low << static_cast<unsigned>(shift));
  return put_exponent(to, unit + 64 - shift);
}

void append_hex_sum(std::string& text, double hi, double lo) {
  std::array<char, kLongestHexSum> buffer;
  if (const char* const end = write_hex_sum(buffer.data(), hi, lo)) {
    text.append(buffer.data(), static_cast<std::size_t>(end - buffer.data()));
  } else {
    append_hex_sum<double>(text, hi, lo);
  }
}

}  // namespace tps
