// One request, one reply: the protocol without its pipes (docs/protocol.md).
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace tps::protocol {

/// Longest request, in bytes without the line's end.
constexpr std::size_t kLongestRequest = std::size_t{1} << 20;

struct Reply {
  std::string text;   ///< one line of JSON without its end; empty for "bye", which has no reply
  bool last = false;  ///< the conversation is over
};

/// The reply to one line. Never throws for anything that a line may hold.
Reply reply_to(std::string_view line);

/// The reply to a line longer than kLongestRequest, of which only the beginning is known.
Reply reply_to_long_line(std::string_view beginning);

}  // namespace tps::protocol
