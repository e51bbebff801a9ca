// The time at which a particle reaches a plane, as integers. Heavy header: only sources of this folder
// include it.
#pragma once

#include <optional>

#include "verify/exact/exact_root.hpp"
#include "verify/exact/lifted_query.hpp"
#include "verify/exact/refined_root.hpp"
#include "verify/exact/timing_query.hpp"

namespace tps::exact {

/// n·r − L and n·v as integers: the first in units of length times unit of the normal. With them t =
/// −gap/w in units of length over units of velocity.
struct LiftedPlane {
  Integer gap, w;
  int unit;  ///< of the normal, a power of two
};

/// REQUIRES units that divide the query's lengths and velocities.
LiftedPlane lifted_plane(const TimingQuery& query, const LiftUnits& units);

/// REQUIRES v ≠ 0.
Verdict plane_verdict_of(const LiftedPlane& plane);

/// The time in double words with a bound on its error; nothing where a square could leave the range.
/// REQUIRES a verdict `hit`.
std::optional<RefinedTime> refined_plane_time(const TimingQuery& query);

/// t = (n·r − L)/(−n·v). REQUIRES a verdict `hit`, and units that divide the query's lengths and velocities.
AlgebraicTime plane_time(const TimingQuery& query, const LiftUnits& units);

}  // namespace tps::exact
