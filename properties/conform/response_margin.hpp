// How far rounding may move the answer of eqs. (3), (4), (6) and (7), and whether it may decide between
// retraction and revolution.
#pragma once

#include "properties/conform/known_question.hpp"

namespace tps::properties::conform {

/// Of a question of tether_response: |c_retract v_n| and tan θ |v_ŵ| are apart by no more than their
/// roundings, 8u(c_retract + tan θ)|v_AB| (docs/check.md, the table of bounds).
bool kind_is_open(const Question& question, int bits);

/// Whether every component of an answer is within the bound that docs/check.md counts out for its equation,
/// in numbers of `bits` bits: K(k) has none where terms cancel to 0. Of a tether's answer only where it
/// retracts; of revolutions and groups never. REQUIRES that the question does not leave the range.
bool within_bounds(const KnownQuestion& known, const Json& out, int bits);

}  // namespace tps::properties::conform
