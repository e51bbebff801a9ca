#include "verify/cli/numbers.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <type_traits>

namespace tps::cli {
namespace {

/// The whole of the text as a number, also nan and inf; nothing where it overflows or is none.
template <typename Number>
std::optional<Number> spelt(const std::string& text) {
  Number value{};
  const char* const end = text.data() + text.size();
  std::from_chars_result result{};
  if constexpr (std::is_floating_point_v<Number>) {
    const bool hexadecimal = text.starts_with("0x") || text.starts_with("0X");
    result = std::from_chars(text.data() + (hexadecimal ? 2 : 0), end, value,
                             hexadecimal ? std::chars_format::hex : std::chars_format::general);
  } else {
    result = std::from_chars(text.data(), end, value);
  }
  if (result.ec != std::errc() || result.ptr != end) return std::nullopt;
  return value;
}

template <typename Number>
CLI::Validator validator(const std::string& what, const std::string& allowed,
                         std::function<bool(Number)> is_allowed) {
  return CLI::Validator(
      [=](const std::string& text) {
        const std::optional<Number> value = spelt<Number>(text);
        if (value && is_allowed(*value)) return std::string();
        return fmt::format("'{}' is not {}; allowed are {}", text, what, allowed);
      },
      allowed);
}

}  // namespace

CLI::Validator number_from(double least, double most, const std::string& what) {
  const bool open = most == std::numeric_limits<double>::infinity();
  return validator<double>(what,
                           open ? fmt::format("numbers from {}, and inf", least)
                                : fmt::format("numbers from {} to {}", least, most),
                           [=](double x) { return x >= least && x <= most; });
}

CLI::Validator number_above_zero(double below, const std::string& what) {
  return validator<double>(what, fmt::format("numbers above 0 and below {}", below),
                           [=](double x) { return x > 0 && x < below; });
}

CLI::Validator integer_from(std::uint64_t least, const std::string& what) {
  return validator<std::uint64_t>(what, fmt::format("integers from {} to 2^64 - 1", least),
                                  [=](std::uint64_t n) { return n >= least; });
}

}  // namespace tps::cli
