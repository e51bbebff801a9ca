// Messages on standard error. Where nobody takes them nothing else fails.
#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <utility>

namespace tps::cli {

template <typename... Arguments>
void say(fmt::format_string<Arguments...> text, Arguments&&... arguments) {
  const std::string message = fmt::format(text, std::forward<Arguments>(arguments)...);
  std::fwrite(message.data(), 1, message.size(), stderr);  // fmt::print throws where that fails
}

}  // namespace tps::cli
