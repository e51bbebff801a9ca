#include "reference/text/printable.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <optional>

namespace tps {
namespace {

/// One character of a text, or one byte that begins none.
struct Piece {
  std::optional<std::uint32_t> code;  ///< none: not UTF-8
  std::size_t bytes = 1;
};

std::uint32_t byte_at(std::string_view text, std::size_t k) {
  return static_cast<unsigned char>(text[k]);
}

/// The first character, as RFC 3629 allows it: shortest form, no surrogates, at most U+10FFFF.
Piece first_piece(std::string_view text) {
  const std::uint32_t lead = byte_at(text, 0);
  if (lead < 0x80) return {lead, 1};
  const std::size_t bytes = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || text.size() < bytes) return {};
  std::uint32_t code = lead & (0xFFU >> (bytes + 1));
  for (std::size_t k = 1; k < bytes; ++k) {
    if ((byte_at(text, k) & 0xC0U) != 0x80) return {};
    code = code << 6U | (byte_at(text, k) & 0x3FU);
  }
  constexpr std::uint32_t kLeast[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
  if (code < kLeast[bytes] || code > 0x10FFFF || surrogate) return {};
  return {code, bytes};
}

bool is_control(std::uint32_t c) {
  return c < 0x20 || (c >= 0x7F && c <= 0x9F);
}

bool is_noncharacter(std::uint32_t c) {
  return (c & 0xFFFEU) == 0xFFFE || (c >= 0xFDD0 && c <= 0xFDEF);
}

/// What a terminal or an editor shows elsewhere, in another order, or not at all.
bool hides_or_reorders(std::uint32_t c) {
  return c == 0xAD || c == 0x61C || c == 0x180E || (c >= 0x200B && c <= 0x200F) ||
         (c >= 0x2028 && c <= 0x202E) || (c >= 0x2060 && c <= 0x206F) || c == 0xFEFF ||
         (c >= 0xFFF9 && c <= 0xFFFB) || (c >= 0xE0000 && c <= 0xE0FFF);
}

bool is_unprintable(std::uint32_t c) {
  return is_control(c) || is_noncharacter(c) || hides_or_reorders(c);
}

std::string escape(std::uint32_t c) {
  switch (c) {
    case '\n':
      return "\\n";
    case '\t':
      return "\\t";
    case '\r':
      return "\\r";
    default:
      return c < 0x80 ? fmt::format("\\x{:02x}", c) : fmt::format("\\u{:04x}", c);
  }
}

std::string shown(std::string_view text, std::size_t most, bool several_lines) {
  std::string result;
  while (!text.empty()) {
    const Piece piece = first_piece(text);
    std::string next;
    if (!piece.code) {
      next = fmt::format("\\x{:02x}", byte_at(text, 0));
    } else if (several_lines && (*piece.code == '\n' || *piece.code == '\t')) {
      next = text.substr(0, 1);
    } else if (is_unprintable(*piece.code)) {
      next = escape(*piece.code);
    } else {
      next = text.substr(0, piece.bytes);
    }
    if (result.size() + next.size() > most) return result + "…";
    result += next;
    text.remove_prefix(piece.bytes);
  }
  return result;
}

}  // namespace

std::string printable(std::string_view text, std::size_t most) {
  return shown(text, most, false);
}

std::string printable_lines(std::string_view text, std::size_t most) {
  return shown(text, most, true);
}

std::string escape_in_json(std::string_view json) {
  std::string result;
  result.reserve(json.size());
  while (!json.empty()) {
    // Nearly all of any text.
    const auto end = std::find_if(json.begin(), json.end(), [](char c) { return c < ' ' || c > '~'; });
    const auto plain = static_cast<std::size_t>(end - json.begin());
    result += json.substr(0, plain);
    json.remove_prefix(plain);
    if (json.empty()) break;
    const Piece piece = first_piece(json);
    const std::uint32_t c = piece.code.value_or(0xFFFD);
    if (c == '\n' || c == '\t' || !is_unprintable(c)) {
      result += json.substr(0, piece.bytes);
    } else if (c < 0x10000) {
      result += fmt::format("\\u{:04x}", c);
    } else {
      result += fmt::format("\\u{:04x}\\u{:04x}", 0xD7C0 + (c >> 10U), 0xDC00 + (c & 0x3FFU));
    }
    json.remove_prefix(piece.bytes);
  }
  return result;
}

std::string xml_text(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const Piece piece = first_piece(text);
    const std::uint32_t c = piece.code.value_or(0);
    if (c == '&') {
      result += "&amp;";
    } else if (c == '<') {
      result += "&lt;";
    } else if (c == '>') {
      result += "&gt;";
    } else if (c == '"') {
      result += "&quot;";
    } else if ((is_control(c) && c != '\n' && c != '\t') || is_noncharacter(c)) {
      result += "\uFFFD";
    } else {
      result += text.substr(0, piece.bytes);
    }
    text.remove_prefix(piece.bytes);
  }
  return result;
}

}  // namespace tps
