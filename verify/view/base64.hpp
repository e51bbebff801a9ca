// Bytes as text: base64 of RFC 4648, padded.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace tps::view {

inline std::string base64(std::string_view bytes) {
  static constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t n = 0; n < bytes.size(); n += 3) {
    std::uint32_t block = 0;
    for (std::size_t k = 0; k < 3; ++k)
      block = block << 8U | (n + k < bytes.size() ? static_cast<unsigned char>(bytes[n + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k) {
      const bool padding = n + k > bytes.size();
      text.push_back(padding ? '=' : kDigits[block >> (18U - 6U * static_cast<unsigned>(k)) & 63U]);
    }
  }
  return text;
}

}  // namespace tps::view
