// What makes a page that carries data and scripts safe to open.
#pragma once

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "reference/text/plain_json.hpp"
#include "verify/view/base64.hpp"

namespace tps::view {

/// JSON that may stand in a script element: no character of markup is left in it.
inline std::string embedded(const nlohmann::ordered_json& value) {
  std::string text;
  for (const char c : json_text(value)) {
    if (c == '<' || c == '>' || c == '&') {
      text += fmt::format("\\u{:04x}", static_cast<int>(c));
    } else {
      text.push_back(c);
    }
  }
  return text;
}

/// What a script or style may be, by its content: a source of CSP level 2.
inline std::string source_hash(std::string_view hex_digest) {
  std::string bytes;
  for (std::size_t n = 0; n + 1 < hex_digest.size(); n += 2)
    bytes.push_back(static_cast<char>(std::stoi(std::string(hex_digest.substr(n, 2)), nullptr, 16)));
  return " 'sha256-" + base64(bytes) + "'";
}

}  // namespace tps::view
