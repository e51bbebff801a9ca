#include "properties/implementations/last_words.hpp"

#include <algorithm>
#include <vector>

namespace tps::properties {
namespace {

/// Of the last lines on standard error: together, and of one that is longer than that.
constexpr std::size_t kShownOfErrors = 400;

/// Blank, or what underlines a part of the line above, as tracebacks do.
bool says_nothing(std::string_view line) {
  return line.find_first_not_of(" \t\r~^") == std::string_view::npos;
}

}  // namespace

std::string shown(std::string_view text, std::size_t most) {
  std::string line;
  for (const char c : text.substr(0, most)) line += c >= ' ' && c <= '~' ? c : c == '\n' ? ' ' : '?';
  while (line.ends_with(' ')) line.pop_back();
  return text.size() > most ? line + " …" : line;
}

std::string last_lines(std::string_view text, bool begins) {
  std::vector<std::string_view> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string_view line = text.substr(at, end - at);
    const bool is_whole = at > 0 || begins || end == text.size();
    if (is_whole && !says_nothing(line)) lines.push_back(line.substr(line.find_first_not_of(" \t")));
    at = end + 1;
  }
  std::string said;
  for (auto line = lines.rbegin(); line != lines.rend(); ++line) {
    if (!said.empty() && said.size() + line->size() > kShownOfErrors) break;
    said = shown(*line, kShownOfErrors) + (said.empty() ? "" : " | ") + said;
  }
  return said;
}

}  // namespace tps::properties
