// The proof of a time under drag: adjacent doubles around t(s), with the sides on which they lie.
#pragma once

#include <optional>
#include <string>

#include "verify/vectors/time_bracket.hpp"

namespace tps::vectors {

/// z = γs exactly, as "0x1a3p-104"; where z < 1 the bracket around t = −ln(1 − z)/γ, whose signs are those of
/// lo − t, hi − t and their middle − t; and by how many units a relative error of one unit in z moves t,
/// z/((1 − z)(−ln(1 − z))), absent for t = 0.
struct DragProof {
  std::string z;
  std::optional<TimeBracket> bracket;
  std::optional<double> condition;
};

/// REQUIRES γ > 0, s ≥ 0. Throws std::invalid_argument where 2^13 bits do not tell a side: such a case has no
/// proof.
DragProof prove_drag_time(double gamma, double s);

}  // namespace tps::vectors
