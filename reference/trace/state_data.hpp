// A full state to and from its line.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "reference/engine/state_data.hpp"

namespace tps {

/// One line of JSON, without its end; `t` is the exact time of `now` on the scene's clock. Its last member is
/// the checksum of the line without that member.
std::string write_state(const StateData& state, const Hex& t);

/// Reads what write_state writes, and nothing else: every key known, every number a hexadecimal float, every
/// list of its length. The checksum is compared with that of the content as write_state spells it, so that
/// spaces and the order of keys do not matter. `file` and `number` say where the line stands.
/// Throws InputError.
StateData read_state(std::string_view line, const std::string& file = "state", std::size_t number = 1);

}  // namespace tps
