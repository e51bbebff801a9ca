// Condition numbers of responses: how much rounding the intermediate numbers costs the result.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "verify/certified/certified_response.hpp"
#include "verify/vectors/known_answer.hpp"

namespace tps::vectors {

/// For each result the size of the largest term that enters it over the size of the result, so that an
/// evaluation that rounds every term to relative u errs by a few u·cond·|result|, |·| being the Euclidean
/// norm. null where the result is zero. Terms: v_A' takes v_A and Δp/m_A; Δp of (4) takes Σ|r_k v_k| against
/// v·r; Δp of (5) takes v and v', with |v|/|v_ŵ| for the direction and 1 + |ln c|θ/π for the power; (6) the
/// two weighted velocities; (7) Δp and μ v; friction the terms of g_t and of both limits.
Json conditions(Op op, const operations::Input& input, const certified::Response& response);

/// 4 (loads + 1) max|v| over the size of each list of velocities.
Json conditions(const operations::GroupInput& group, const certified::GroupResponse& response);

}  // namespace tps::vectors
