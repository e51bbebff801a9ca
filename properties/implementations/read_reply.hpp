// Lines of the protocol (docs/protocol.md), seen from the side that asks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "properties/implementation.hpp"

namespace tps::properties {

/// {"seq":n,"op":…,"in":{…}} without the line's end.
std::string request_line(std::uint64_t seq, const Question& question);

/// What the other program said, fit for a line of a report; of words at most `longest` characters.
std::string words(const Json& value, std::size_t longest);

/// The reply to request `seq`. Whatever is no reply is `failed` and says what was found instead.
Answer read_reply(std::string_view line, std::uint64_t seq);

}  // namespace tps::properties
