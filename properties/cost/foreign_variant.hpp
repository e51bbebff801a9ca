// Anybody's implementation of the timing queries as a variant of `tps cost` (docs/accuracy-cost.md).
#pragma once

#include <string>
#include <vector>

#include "properties/implementation.hpp"
#include "verify/cost/variant.hpp"

namespace tps::properties {

/// What --variant and tables call it.
inline constexpr const char* kForeignName = "command";

/// A variant that asks a program which speaks the protocol. Its time is that of the clock on the wall, pipes
/// included. Throws ProgramError where it cannot be started or has no block_time or tether_time, and from its
/// functions where a reply is none.
cost::Variant foreign_variant(const std::vector<std::string>& words);

/// A number of a reply, a hexadecimal float of any length or a JSON number, without rounding up to 416 bits.
/// Throws ProgramError.
cost::ExactNumber exact_number_of(const Json& number);

/// A reply to block_time or tether_time. A refusal is no event. Throws ProgramError where it is no reply.
cost::Answer answer_of(const Answer& reply);

}  // namespace tps::properties
