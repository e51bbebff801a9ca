#include "reference/text/hexfloat.hpp"

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <charconv>
#include <iterator>

namespace tps {
namespace {

using boost::multiprecision::cpp_int;

int digit_value(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

cpp_int integer(const HexDigits& hex) {
  std::vector<unsigned char> nibbles;
  for (const char c : hex.digits) nibbles.push_back(static_cast<unsigned char>(digit_value(c)));
  cpp_int magnitude;
  boost::multiprecision::import_bits(magnitude, nibbles.begin(), nibbles.end(), 4);
  return hex.negative ? cpp_int(-magnitude) : magnitude;
}

void trim(HexDigits& hex) {
  const std::size_t first = hex.digits.find_first_not_of('0');
  if (first == std::string::npos) {
    hex.digits.clear();
    hex.exponent = 0;
    return;
  }
  hex.digits.erase(0, first);
  const std::size_t last = hex.digits.find_last_not_of('0');
  hex.exponent += 4 * static_cast<long>(hex.digits.size() - 1 - last);
  hex.digits.erase(last + 1);
}

}  // namespace

std::optional<HexDigits> split_hex(std::string_view text) {
  HexDigits hex;
  if (!text.empty() && (text.front() == '-' || text.front() == '+')) {
    hex.negative = text.front() == '-';
    text.remove_prefix(1);
  }
  if (text.size() < 3 || text[0] != '0' || (text[1] != 'x' && text[1] != 'X')) return std::nullopt;
  text.remove_prefix(2);
  bool point = false;
  std::size_t used = 0;
  for (; used < text.size(); ++used) {
    const char c = text[used];
    if (c == '.' && !point) {
      point = true;
      continue;
    }
    const int value = digit_value(c);
    if (value < 0) break;
    hex.digits.push_back("0123456789abcdef"[value]);
    if (point) hex.exponent -= 4;
  }
  if (hex.digits.empty()) return std::nullopt;
  text.remove_prefix(used);
  if (!text.empty()) {
    if (text.front() != 'p' && text.front() != 'P') return std::nullopt;
    text.remove_prefix(1);
    if (!text.empty() && text.front() == '+') text.remove_prefix(1);
    long exponent = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), exponent);
    constexpr long kLimit = 1L << 20;  // sums are exact: the digits between two exponents are written out
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    if (exponent > kLimit || exponent < -kLimit) return std::nullopt;
    hex.exponent += exponent;
  }
  trim(hex);
  return hex;
}

std::string join_hex(const HexDigits& hex) {
  std::string text;
  if (hex.negative) text.push_back('-');
  if (hex.digits.empty()) return text.append("0x0p+0");
  // Shift so that the leading digit is 1: its lower bits move into the digits behind it.
  const int lead = digit_value(hex.digits.front());
  const int extra = lead >= 8 ? 3 : lead >= 4 ? 2 : lead >= 2 ? 1 : 0;
  const long exponent = hex.exponent + 4 * static_cast<long>(hex.digits.size() - 1) + extra;
  std::string fraction;
  int carry = lead & ((1 << extra) - 1);
  for (std::size_t k = 1; k < hex.digits.size(); ++k) {
    const int value = (carry << 4) | digit_value(hex.digits[k]);
    fraction.push_back("0123456789abcdef"[value >> extra]);
    carry = value & ((1 << extra) - 1);
  }
  if (extra > 0) fraction.push_back("0123456789abcdef"[carry << (4 - extra)]);
  fraction.erase(fraction.find_last_not_of('0') + 1);
  text.append("0x1");
  if (!fraction.empty()) text.append(1, '.').append(fraction);
  text.append(exponent < 0 ? "p-" : "p+");
  return text.append(std::to_string(std::abs(exponent)));
}

HexDigits exact_sum(std::span<const HexDigits> terms) {
  long lowest = 0;
  bool first = true;
  for (const HexDigits& term : terms) {
    if (term.digits.empty()) continue;
    lowest = first ? term.exponent : std::min(lowest, term.exponent);
    first = false;
  }
  cpp_int total = 0;
  for (const HexDigits& term : terms) {
    if (!term.digits.empty()) total += integer(term) << static_cast<unsigned long>(term.exponent - lowest);
  }
  HexDigits sum;
  sum.negative = total < 0;
  sum.exponent = lowest;
  std::vector<unsigned char> nibbles;
  boost::multiprecision::export_bits(cpp_int(boost::multiprecision::abs(total)), std::back_inserter(nibbles),
                                     4);
  for (const unsigned char nibble : nibbles) sum.digits.push_back("0123456789abcdef"[nibble]);
  trim(sum);
  return sum;
}

int significant_bits(const HexDigits& hex) {
  if (hex.digits.empty()) return 0;
  const auto width = [](int v) { return v >= 8 ? 4 : v >= 4 ? 3 : v >= 2 ? 2 : 1; };
  const int last = digit_value(hex.digits.back());
  const int trailing = (last & 1) != 0 ? 0 : (last & 2) != 0 ? 1 : (last & 4) != 0 ? 2 : 3;
  return 4 * static_cast<int>(hex.digits.size() - 1) + width(digit_value(hex.digits.front())) - trailing;
}

}  // namespace tps
