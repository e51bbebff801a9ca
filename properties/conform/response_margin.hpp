// Whether rounding may decide between retraction and revolution.
#pragma once

#include "properties/implementation.hpp"

namespace tps::properties::conform {

/// Of a question of tether_response: |c_retract v_n| and tan θ |v_ŵ| are apart by no more than their
/// roundings, 8u(c_retract + tan θ)|v_AB| (docs/check.md, the table of bounds).
bool kind_is_open(const Question& question, int bits);

}  // namespace tps::properties::conform
