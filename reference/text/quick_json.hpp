// The short road of parse_json(): texts without errors, escapes or letters beyond ASCII, which nearly all
// lines of traces and of the protocol are.
#pragma once

#include <optional>

#include "reference/text/json_document.hpp"

namespace tps {

/// The tree that parse_json() builds, to the line numbers; nothing for a text that the short road does not
/// take, be it wrong or merely unusual.
std::optional<JsonValue> quick_json(std::string_view text, const JsonLimits& limits, std::size_t first_line);

/// The long road: parse_json() without the short one.
JsonDocument parse_any_json(std::string_view text, const std::string& name, const JsonLimits& limits = {},
                            std::size_t first_line = 1);

/// An integer of 64 bits: the nearest double, and whether it is the integer.
JsonNumber natural_number(std::uint64_t value);
/// REQUIRES value < 0.
JsonNumber negative_number(std::int64_t value);

}  // namespace tps
