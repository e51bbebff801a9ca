// The operations of the protocol, answered from JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "verify/operations/compound_input.hpp"

namespace tps::protocol {

/// The operations that the protocol answers.
const std::vector<std::string>& operation_names();

/// The result of an operation as a JSON object, numbers as hexadecimal floats.
///
/// Every number is the correct rounding of the real one that the stored doubles define, unless the answer is
/// flagged: "unsettled" where 2^14 bits do not tell it, "simulated" where a scene of `next_event` calls for
/// more effects than rebound, tethering and grouping or draws. `place` says in messages where `in` stands.
/// REQUIRES an operation of operation_names(), and none that answers a trace: that is only a text. Throws
/// InputError with what is wrong with `in`.
nlohmann::ordered_json answer(operations::Op op, const JsonValue& in, const operations::Place& place);

/// The same as text. REQUIRES an operation of operation_names().
std::string answer_text(operations::Op op, const JsonValue& in, const operations::Place& place);

/// {"order":"before"} and so on.
nlohmann::ordered_json answer_order(const operations::OrderInput& input);

}  // namespace tps::protocol
