#include "verify/cli/numbers.hpp"

#include <fmt/format.h>

#include <charconv>
#include <functional>
#include <limits>
#include <optional>

#include "reference/text/typed_number.hpp"

namespace tps::cli {
namespace {

CLI::Validator validator(const std::string& what, const std::string& allowed,
                         std::function<bool(const std::string&)> is_allowed) {
  return CLI::Validator(
      [=](const std::string& text) {
        if (is_allowed(text)) return std::string();
        return fmt::format("'{}' is not {}; allowed are {}", text, what, allowed);
      },
      allowed);
}

CLI::Validator validator_of_reals(const std::string& what, const std::string& allowed,
                                  std::function<bool(double)> is_allowed) {
  return validator(what, allowed, [=](const std::string& text) {
    const std::optional<double> value = typed_number(text).value;
    return value && is_allowed(*value);
  });
}

}  // namespace

CLI::Validator number_from(double least, double most, const std::string& what) {
  const bool open = most == std::numeric_limits<double>::infinity();
  return validator_of_reals(what,
                            open ? fmt::format("numbers from {}, and inf", least)
                                 : fmt::format("numbers from {} to {}", least, most),
                            [=](double x) { return x >= least && x <= most; });
}

CLI::Validator number_above_zero(double below, const std::string& what) {
  return validator_of_reals(what, fmt::format("numbers above 0 and below {}", below),
                            [=](double x) { return x > 0 && x < below; });
}

CLI::Validator integer_from(std::uint64_t least, const std::string& what) {
  return validator(what, fmt::format("integers from {} to 2^64 - 1", least), [=](const std::string& text) {
    std::uint64_t n = 0;
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, n);
    return error == std::errc() && rest == end && n >= least;
  });
}

}  // namespace tps::cli
