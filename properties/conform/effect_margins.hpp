// How far rounding may move the answers to wall_time, drag_time and rough_impulse (docs/conform.md).
#pragma once

#include <map>
#include <string>

#include "properties/conform/mistakes.hpp"
#include "properties/conform/timing_margin.hpp"

namespace tps::properties::conform {

/// Of a plane: n·r − L errs by 6u(Σ|n_k r_k| + L), n·v by 5u Σ|n_k v_k| (a difference, a product, two sums,
/// and one more for L), their quotient by u. Never `printed`.
Margin margin_of_plane(const exact::TimingQuery& query, const TimeAnswer& answer, int bits);

/// Of t = −ln(1 − z)/γ, z = γs. `stable`: z rounded once, a logarithm good to 2 ulps, a quotient: z (1 ± 2u)
/// and 4u t. `printed`: 1 − z rounded as well, so that z is off by u more, which is all of it for z below u.
Margin margin_of_drag(const Json& in, const TimeAnswer& answer, int bits);

/// Of a question of rough_impulse: whether what holds the surfaces and what friction can give are apart by no
/// more than their errors, κ (1 + β₀) m (18 G + 8|g_t|) u and μ (1 + c) m (9|v_AB| + 10|v_n|) u
/// (docs/effects.md, "Bound of J_t").
bool friction_is_open(const Question& question, int bits);

/// Bounds of the results of rough_impulse for an answer of this kind, in units u, by their keys.
std::map<std::string, double> rough_bounds(const Given& given, const std::string& kind);

}  // namespace tps::properties::conform
