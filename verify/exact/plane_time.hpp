// The time at which a particle reaches a plane, as integers. Heavy header: only sources of this folder
// include it.
#pragma once

#include <optional>

#include "verify/exact/exact_root.hpp"
#include "verify/exact/refined_root.hpp"
#include "verify/exact/timing_query.hpp"

namespace tps::exact {

/// The same in double words with a bound on its error; nothing where a square could leave the range.
/// REQUIRES a verdict `hit`.
std::optional<RefinedTime> refined_plane_time(const TimingQuery& query);

/// t = (n·r − L)/(−n·v). REQUIRES a verdict `hit`, and units that divide the query's lengths and velocities.
AlgebraicTime plane_time(const TimingQuery& query, const LiftUnits& units);

}  // namespace tps::exact
