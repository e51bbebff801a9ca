// Judges answers by known ones, and the known ones by proving them again.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "verify/vectors/known_answer.hpp"

namespace tps::vectors {

/// What is wrong with a stored case, in words: its "in" is no question of the operation, or a field of the
/// answer differs from what is computed again. Never throws for anything that a case may hold.
std::optional<std::string> wrong_in_case(Op op, const Json& known_case);

/// What is wrong with somebody's "out" (interface: the operation's results; numbers as hexadecimal floats or
/// JSON numbers). It passes if one of the case's `accept` classes does: R, every number is the correctly
/// rounded one; U(k), within k units in the last place of the enclosure; K(k), within k·2^-53·cond·|result|
/// of it (u = 2^-53). A verdict, an order or a kind has to be the known one; a verdict that is not given is
/// not judged, but then t must be there.
std::optional<std::string> wrong_in_answer(Op op, const Json& known_case, const Json& out);

/// Why the state of next_event's "out" is not one of so many particles; nothing where it is, or is missing.
std::optional<std::string> wrong_state(const Json& out, std::size_t particles);

/// The "out" of next_event as a known answer has it: `positions` and `velocities`, a row a particle, in the
/// order of ids. REQUIRES a state that is none wrong, or none.
Json in_rows(Json out);

/// Of an answer to a timing query.
constexpr const char* kSaysNothing =
    "out has neither verdict nor t; it must say what happens, with t null where nothing does";

}  // namespace tps::vectors
