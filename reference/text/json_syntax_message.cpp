#include "reference/text/json_syntax_message.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <limits>

namespace tps {
namespace {

constexpr std::size_t kLongestWord = 60;

/// The run of letters, digits and signs around the last consumed byte.
std::string_view word_at(std::string_view text, std::size_t consumed) {
  const auto in_word = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '+' || c == '-' || c == '.';
  };
  std::size_t begin = consumed > 0 ? consumed - 1 : 0;
  // The parser reads one byte more than a number to see that it ends.
  if (begin > 0 && !in_word(text[begin])) --begin;
  while (begin > 0 && in_word(text[begin]) && in_word(text[begin - 1])) --begin;
  std::size_t end = begin;
  while (end < text.size() && in_word(text[end]) && end - begin <= kLongestWord) ++end;
  return text.substr(begin, end - begin);
}

std::size_t column_of(std::string_view text, std::size_t consumed) {
  if (consumed == 0) return 1;
  const std::size_t line_end = consumed > 1 ? text.rfind('\n', consumed - 2) : std::string_view::npos;
  return line_end == std::string_view::npos ? consumed : consumed - line_end - 1;
}

bool is_no_finite_number(std::string_view word) {
  std::string lower;
  for (const char c : word) lower += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  const std::string bare = lower.substr(std::min(lower.find_first_not_of("+-"), lower.size()));
  return bare == "nan" || bare == "inf" || bare == "infinity";
}

/// The library's text is "[…] parse error at …: syntax error while … - REASON; last read: '…'; expected …".
/// "Last read" can be as long as the file and hold any bytes: it is left out.
std::string reason_in(std::string_view what) {
  const std::size_t reason = what.find(" - ");
  if (reason == std::string_view::npos) return "";
  const std::size_t quote = what.find("; last read: '");
  const std::size_t expected = what.rfind("'; expected ");
  std::string text = ": ";
  text += what.substr(reason + 3, quote == std::string_view::npos ? quote : quote - reason - 3);
  if (quote != std::string_view::npos && expected != std::string_view::npos)
    text += what.substr(expected + 1);
  return text;
}

}  // namespace

std::string json_syntax_message(int id, std::string_view what, std::string_view text, std::size_t consumed) {
  constexpr int kNumberOverflow = 406;  // "out_of_range.406" of the library
  const std::string_view word = word_at(text, consumed);
  if (id == kNumberOverflow) {
    return fmt::format("number {}{} is beyond the largest double, {}", word.substr(0, kLongestWord),
                       word.size() > kLongestWord ? "…" : "", std::numeric_limits<double>::max());
  }
  if (is_no_finite_number(word)) {
    return fmt::format("found {}; allowed: JSON numbers, and the string \"inf\" where the format says so",
                       word);
  }
  if (consumed > 0 && text[consumed - 1] == '/') {
    return fmt::format("not JSON: unexpected '/'; JSON has no comments (column {})",
                       column_of(text, consumed));
  }
  return fmt::format("not JSON{} (column {})", reason_in(what), column_of(text, consumed));
}

}  // namespace tps
