// Text of others made safe to print: to a terminal, into a report, into XML.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace tps {

/// As much of a found text as a line of a message can bear.
inline constexpr std::size_t kShownOfText = 60;

/// The text as one line of visible UTF-8, at most `most` bytes of it and then "…".
///
/// Escaped are bytes that are not UTF-8 (`\xff`), control characters of both blocks (`\n`, `\t`, `\x1b`,
/// `\u009b`), what reorders or hides text (bidirectional marks, zero-width characters, line separators, byte
/// order marks) and noncharacters. A backslash stays as it is.
/// (1) printable(printable(x, n), m) = printable(x, n) for m large enough.
std::string printable(std::string_view text, std::size_t most = std::string_view::npos);

/// The same for text of several lines: line ends and tabs stay.
std::string printable_lines(std::string_view text, std::size_t most = std::string_view::npos);

/// A text of JSON with what printable() escapes as escapes of JSON, but line ends and tabs. REQUIRES UTF-8.
std::string escape_in_json(std::string_view json);

/// The text as content or attribute of XML 1.0 in UTF-8: `&`, `<`, `>` and `"` as entities; what XML
/// cannot hold, and bytes that are not UTF-8, as U+FFFD. Line ends and tabs stay.
std::string xml_text(std::string_view text);

}  // namespace tps
