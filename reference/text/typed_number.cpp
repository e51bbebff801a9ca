#include "reference/text/typed_number.hpp"

#include <charconv>
#include <cmath>
#include <cstdlib>

#include "reference/text/number_text.hpp"

namespace tps {

TypedNumber typed_number(const std::string& text) {
  if (text == "inf" || text == "+inf") return {HUGE_VAL, ""};
  if (text == "-inf") return {-HUGE_VAL, ""};
  if (text.find_first_of("xX") != std::string::npos) {
    const HexFloat hex = parse_hex_float(text);
    if (hex.verdict == HexFloat::Verdict::exact) return {hex.value, ""};
    if (hex.verdict == HexFloat::Verdict::not_a_double) return {{}, "is a number that no double has"};
    return {{}, "is not a hexadecimal float such as 0x1.8p+1"};
  }
  const char* begin = text.data() + (text.starts_with('+') ? 1 : 0);
  const char* end = text.data() + text.size();
  double value = 0;
  const auto [rest, error] = std::from_chars(begin, end, value);
  if (error == std::errc::result_out_of_range && rest == end) {
    const double nearest = std::strtod(begin, nullptr);  // 0 or a subnormal number is one; infinity is none
    return std::isfinite(nearest) ? TypedNumber{nearest, ""}
                                  : TypedNumber{{}, "is outside the range of double"};
  }
  if (error != std::errc() || rest != end || !std::isfinite(value)) {
    return {{}, "is not a number; write a decimal, a hexadecimal float or inf"};
  }
  return {value, ""};
}

}  // namespace tps
