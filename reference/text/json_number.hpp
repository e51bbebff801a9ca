// Numbers as every file of ours spells them.
#pragma once

#include <cstdint>
#include <optional>

#include "reference/text/json_document.hpp"

namespace tps {

/// A JSON number (the nearest double), a string with a hexadecimal float (exact), or the string "inf".
/// None where the value is nothing of these; never NaN. Whether "inf" and which range is allowed is for the
/// schema to say.
std::optional<double> json_number(const JsonValue& value);

/// An unsigned integer of 64 bits: a JSON number that holds one exactly, or a string with a decimal or a
/// hexadecimal ("0x…") integer. None where the value is nothing of these.
std::optional<std::uint64_t> json_uint64(const JsonValue& value);

}  // namespace tps
