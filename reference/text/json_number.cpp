#include "reference/text/json_number.hpp"

#include <charconv>
#include <cmath>
#include <limits>
#include <string_view>

#include "reference/text/number_text.hpp"

namespace tps {

std::optional<double> json_number(const JsonValue& value) {
  if (const JsonNumber* number = value.number()) return number->value;
  const std::string* text = value.string();
  if (text == nullptr) return std::nullopt;
  if (*text == "inf") return std::numeric_limits<double>::infinity();
  const HexFloat hex = parse_hex_float(*text);
  if (hex.verdict != HexFloat::Verdict::exact) return std::nullopt;
  return hex.value;
}

std::optional<std::uint64_t> json_uint64(const JsonValue& value) {
  if (const JsonNumber* number = value.number()) {
    const bool exact = !number->rounded_integer && number->value >= 0 && number->value < 0x1p64 &&
                       std::trunc(number->value) == number->value;
    if (!exact) return std::nullopt;
    return static_cast<std::uint64_t>(number->value);
  }
  const std::string* string = value.string();
  if (string == nullptr) return std::nullopt;
  std::string_view text = *string;
  const bool hex = text.starts_with("0x") || text.starts_with("0X");
  if (hex) text.remove_prefix(2);
  std::uint64_t result = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), result, hex ? 16 : 10);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return result;
}

}  // namespace tps
