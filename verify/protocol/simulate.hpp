// A run as one reply: the lines of its trace in a list.
#pragma once

#include <string>

#include "verify/operations/compound_input.hpp"

namespace tps::protocol {

/// {"trace":[…]}: the lines of the full trace (docs/trace.md) that `tps run --timing certified` writes of the
/// scene. Throws InputError with what is wrong with `in`, and where the trace has more than kLongestTrace
/// bytes.
std::string simulate(const JsonValue& in, const operations::Place& place);

constexpr std::size_t kLongestTrace = std::size_t{1} << 24;

}  // namespace tps::protocol
