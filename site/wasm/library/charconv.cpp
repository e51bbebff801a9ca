#include <charconv>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>

namespace {

std::to_chars_result put(char* first, char* last, std::string_view text) {
  if (text.size() > static_cast<std::size_t>(last - first)) return {last, std::errc::value_too_large};
  return {std::copy(text.begin(), text.end(), first), std::errc()};
}

/// The shortest digits that read back, as 0.d₁d₂… · 10^exponent. REQUIRES a finite number above 0.
struct Digits {
  std::string digits;
  int exponent = 0;
};

Digits shortest(double value) {
  const std::string text =
      fmt::format("{}", value);  // its digits are the shortest ones; its layout is another
  const std::size_t e = std::min(text.find('e'), text.size());
  const std::size_t point = std::min(text.find('.'), e);
  Digits result{text.substr(0, point) + (point < e ? text.substr(point + 1, e - point - 1) : ""),
                static_cast<int>(point) + (e < text.size() ? std::atoi(text.c_str() + e + 1) : 0)};
  const std::size_t first = result.digits.find_first_not_of('0');
  result.exponent -= static_cast<int>(first);
  result.digits = result.digits.substr(first, result.digits.find_last_not_of('0') + 1 - first);
  return result;
}

std::string fixed(const Digits& d) {
  const auto size = static_cast<int>(d.digits.size());
  if (d.exponent <= 0) return "0." + std::string(static_cast<std::size_t>(-d.exponent), '0') + d.digits;
  if (d.exponent >= size) return d.digits + std::string(static_cast<std::size_t>(d.exponent - size), '0');
  return d.digits.substr(0, static_cast<std::size_t>(d.exponent)) + "." +
         d.digits.substr(static_cast<std::size_t>(d.exponent));
}

std::string scientific(const Digits& d) {
  const int exponent = d.exponent - 1;
  return d.digits.substr(0, 1) + (d.digits.size() > 1 ? "." + d.digits.substr(1) : "") +
         fmt::format("e{}{:02}", exponent < 0 ? '-' : '+', std::abs(exponent));
}

}  // namespace

namespace std {

// [charconv.to.chars]: the shorter of the two layouts, the fixed one where they are equally long. Where the
// fixed one is an integer it has the exact digits.
to_chars_result to_chars(char* first, char* last, double value) {
  const std::string sign = signbit(value) ? "-" : "";
  const double magnitude = fabs(value);
  if (isinf(value)) return put(first, last, sign + "inf");
  if (isnan(value)) return put(first, last, sign + "nan");
  if (magnitude == 0) return put(first, last, sign + "0");
  const Digits digits = shortest(magnitude);
  const std::string exponential = scientific(digits);
  string plain = fixed(digits);
  if (digits.exponent > static_cast<int>(digits.digits.size())) plain = fmt::format("{:.0f}", magnitude);
  return put(first, last, sign + (plain.size() <= exponential.size() ? plain : exponential));
}

// As printf's %a, without the prefix, from the bits. REQUIRES chars_format::hex.
to_chars_result to_chars(char* first, char* last, double value, chars_format) {
  uint64_t bits = 0;
  memcpy(&bits, &value, sizeof bits);
  constexpr unsigned kFraction = 52;
  const auto biased = static_cast<int>(bits >> kFraction & 0x7ffU);
  string fraction = fmt::format("{:013x}", bits & ((uint64_t{1} << kFraction) - 1));
  fraction.erase(fraction.find_last_not_of('0') + 1);
  const int exponent = value == 0 ? 0 : biased == 0 ? -1022 : biased - 1023;
  return put(first, last,
             fmt::format("{}{}{}{}p{:+}", signbit(value) ? "-" : "", biased == 0 ? 0 : 1,
                         fraction.empty() ? "" : ".", fraction, exponent));
}

from_chars_result from_chars(const char* first, const char* last, double& value, chars_format format) {
  const bool hex = format == chars_format::hex;
  const char* start = first;
  const bool negative = start != last && *start == '-';
  if (negative) ++start;
  const auto is_start = [&](char c) {
    return (c >= '0' && c <= '9') || c == '.' || c == 'i' || c == 'n' || (hex && isxdigit(c));
  };
  if (start == last || !is_start(*start)) return {first, errc::invalid_argument};
  // strtod takes a prefix that from_chars does not: 0x of a decimal.
  if (!hex && last - start > 1 && start[0] == '0' && (start[1] | 0x20) == 'x') {
    value = negative ? -0.0 : 0.0;
    return {start + 1, errc()};
  }
  const string text = (hex ? "0x" : "") + string(start, last);
  char* end = nullptr;
  const double read = strtod(text.c_str(), &end);
  const auto used = end - text.c_str() - (hex ? 2 : 0);
  if (used <= 0) return {first, errc::invalid_argument};
  if (isinf(read) && *start != 'i') return {start + used, errc::result_out_of_range};
  value = negative ? -read : read;
  return {start + used, errc()};
}

}  // namespace std
