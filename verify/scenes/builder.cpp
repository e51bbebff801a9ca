#include "verify/scenes/builder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <stdexcept>

#include "reference/text/typed_number.hpp"

namespace tps {
namespace {

bool contains(Range range, double value) {
  return (range.least_allowed ? value >= range.least : value > range.least) && value <= range.most;
}

[[noreturn]] void refuse(const std::string& option, const std::string& text, const std::string& allowed) {
  throw std::invalid_argument(fmt::format("--{} is \"{}\"; allowed is {}", option, text, allowed));
}

/// The integer that the whole of `text` spells, if it does.
template <typename Integer>
bool spells(const std::string& text, Integer& number) {
  const char* const end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, number);
  return result.ec == std::errc() && result.ptr == end;
}

}  // namespace

std::string describe(double value) {
  return fmt::format("{}", value);
}

std::string describe(Range range, bool integer) {
  const char* const kind = integer ? "an integer" : "a number";
  const std::string least =
      fmt::format("{} {}", range.least_allowed ? "from" : "above", describe(range.least));
  if (range.most == std::numeric_limits<double>::infinity()) {
    return fmt::format("{} {}{}", kind, least, integer ? "" : ", or inf");
  }
  if (range.most == std::numeric_limits<double>::max()) return fmt::format("{} {}", kind, least);
  return fmt::format("{} {} to {}", kind, least, describe(range.most));
}

double parse_real(const std::string& option, const std::string& text, Range range) {
  const TypedNumber typed = typed_number(text);
  if (!typed.value || !contains(range, *typed.value)) refuse(option, text, describe(range, false));
  return *typed.value;
}

int parse_integer(const std::string& option, const std::string& text, Range range) {
  int value = 0;
  if (!spells(text, value) || !contains(range, value)) refuse(option, text, describe(range, true));
  return value;
}

std::uint64_t parse_seed(const std::string& option, const std::string& text) {
  std::uint64_t value = 0;
  if (!spells(text, value)) refuse(option, text, "an integer from 0 to 2^64 - 1");
  return value;
}

void check_names(const SceneBuilder& builder, const OptionValues& values) {
  for (const auto& value : values) {
    const std::string& name = value.first;
    const bool known = std::any_of(builder.options.begin(), builder.options.end(),
                                   [&](const BuilderOption& option) { return option.name == name; });
    if (known) continue;
    std::string names;
    for (const BuilderOption& option : builder.options) names += " --" + option.name;
    throw std::invalid_argument(
        fmt::format("the scene \"{}\" has no option --{}; it has{}", builder.name, name, names));
  }
}

}  // namespace tps
