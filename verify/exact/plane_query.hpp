// A plane and a particle: n·(r + v t) = L is linear, so that the time is a quotient of two integers
// (docs/exact.md, "Planes").
#pragma once

#include "verify/exact/counters.hpp"
#include "verify/exact/timing_query.hpp"
#include "verify/exact/verdict.hpp"

namespace tps::exact {

/// The verdict that real arithmetic gives on the stored doubles: `static`, `receding` for n·v ≥ 0, else
/// `overlap`, `contact` or `hit` as n·r is below, at or above L. The normal need not have length 1: distances
/// are in its units. REQUIRES valid(query), query.kind == Kind::plane.
Verdict plane_verdict(const TimingQuery& query, Counters& counters);

}  // namespace tps::exact
