#include "reference/text/hexfloat.hpp"

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cstdlib>
#include <iterator>

namespace tps {
namespace {

using boost::multiprecision::cpp_int;

cpp_int integer(const HexDigits& hex) {
  std::vector<unsigned char> nibbles;
  for (const char c : hex.digits) nibbles.push_back(static_cast<unsigned char>(hex_digit(c)));
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

std::optional<HexSpelling> hex_spelling(std::string_view text) {
  const auto take_sign = [&] {
    const bool negative = text.starts_with('-');
    if (negative || text.starts_with('+')) text.remove_prefix(1);
    return negative;
  };
  const auto take_digits = [&](auto is_digit) {
    const auto end = std::find_if_not(text.begin(), text.end(), is_digit);
    const std::string_view digits = text.substr(0, static_cast<std::size_t>(end - text.begin()));
    text.remove_prefix(digits.size());
    return digits;
  };
  const auto is_hexadecimal = [](char c) { return hex_digit(c) >= 0; };

  HexSpelling spelling;
  spelling.negative = take_sign();
  if (!text.starts_with("0x") && !text.starts_with("0X")) return std::nullopt;
  text.remove_prefix(2);
  spelling.whole = take_digits(is_hexadecimal);
  if (text.starts_with('.')) {
    text.remove_prefix(1);
    spelling.fraction = take_digits(is_hexadecimal);
  }
  if (spelling.whole.empty() && spelling.fraction.empty()) return std::nullopt;
  if (!text.starts_with('p') && !text.starts_with('P')) return std::nullopt;
  text.remove_prefix(1);
  const bool below_one = take_sign();
  const std::string_view power = take_digits([](char c) { return c >= '0' && c <= '9'; });
  if (power.empty() || !text.empty()) return std::nullopt;
  constexpr std::int64_t bound = std::int64_t{1} << 60;
  std::int64_t exponent = 0;
  for (const char c : power) exponent = exponent < bound / 16 ? 10 * exponent + (c - '0') : bound;
  spelling.exponent = below_one ? -exponent : exponent;
  return spelling;
}

std::optional<HexDigits> split_hex(std::string_view text) {
  const std::optional<HexSpelling> spelling = hex_spelling(text);
  constexpr long kLimit = 1L << 20;  // sums are exact: the digits between two exponents are written out
  if (!spelling || std::abs(spelling->exponent) > kLimit) return std::nullopt;
  HexDigits hex{spelling->negative, std::string(spelling->whole),
                static_cast<long>(spelling->exponent) - 4 * static_cast<long>(spelling->fraction.size())};
  hex.digits.append(spelling->fraction);
  for (char& digit : hex.digits) digit = "0123456789abcdef"[hex_digit(digit)];
  trim(hex);
  return hex;
}

std::string join_hex(const HexDigits& hex) {
  std::string text;
  if (hex.negative) text.push_back('-');
  if (hex.digits.empty()) return text.append("0x0p+0");
  // Shift so that the leading digit is 1: its lower bits move into the digits behind it.
  const int lead = hex_digit(hex.digits.front());
  const int extra = lead >= 8 ? 3 : lead >= 4 ? 2 : lead >= 2 ? 1 : 0;
  const long exponent = hex.exponent + 4 * static_cast<long>(hex.digits.size() - 1) + extra;
  std::string fraction;
  int carry = lead & ((1 << extra) - 1);
  for (std::size_t k = 1; k < hex.digits.size(); ++k) {
    const int value = (carry << 4) | hex_digit(hex.digits[k]);
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
  const int last = hex_digit(hex.digits.back());
  const int trailing = (last & 1) != 0 ? 0 : (last & 2) != 0 ? 1 : (last & 4) != 0 ? 2 : 3;
  return 4 * static_cast<int>(hex.digits.size() - 1) + width(hex_digit(hex.digits.front())) - trailing;
}

}  // namespace tps
