// The operations of the protocol, answered from JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "reference/text/json_document.hpp"
#include "verify/protocol/read_input.hpp"

namespace tps::protocol {

/// The operations that answer() knows: those of numbers in the order of the paper, then the others.
const std::vector<std::string>& operation_names();

/// Whose answer, a trace, is only a text.
inline constexpr std::string_view kSimulate = "simulate";

/// The result of an operation as a JSON object, numbers as hexadecimal floats.
///
/// Every number is the correct rounding of the real one that the stored doubles define, unless the answer is
/// flagged: "unsettled" where 2^14 bits do not tell it, "simulated" where a scene of `next_event` calls for
/// more effects than rebound, tethering and grouping or draws. `source` and `pointer` say in messages where
/// `in` stands. REQUIRES one of operation_names() but kSimulate. Throws InputError with what is wrong with
/// `in`.
nlohmann::ordered_json answer(std::string_view operation, const JsonValue& in, const std::string& source,
                              const std::string& pointer);

/// The same as text. REQUIRES one of operation_names().
std::string answer_text(std::string_view operation, const JsonValue& in, const std::string& source,
                        const std::string& pointer);

/// {"order":"before"} and so on.
nlohmann::ordered_json answer_order(const OrderInput& input);

}  // namespace tps::protocol
