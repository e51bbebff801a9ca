// Runs that are turned round: states of a trace moved to one time, their velocities reversed, in the run's
// own scalar.
#pragma once

#include <string>

#include "properties/runs/judge.hpp"
#include "properties/runs/trace.hpp"
#include "reference/scene/scene.hpp"

namespace tps::properties::runs {

/// The beginning of a trace (its header and one full state at time 0) of the run back: all particles where a
/// finished run has them at its end, which must be its scene's duration, with opposite velocities, plus
/// `shift` times (1, −1, 1, …) in every coordinate. Pairs that have responded may do so again. Scalars:
/// double, mp50, mp100; throws std::invalid_argument for others.
std::string turned_round(const RunTrace& run, const Scene& scene, const std::string& scalar, Real shift = 0);

/// How far apart two finished runs of one scene have their particles at its duration: the largest component,
/// of places and of velocities, `sign` times those of the second.
Real parted(const RunTrace& a, const RunTrace& b, const Scene& scene, Real sign = 1);

/// How far a finished run has its particles from the scene's starts and opposite velocities.
Real away_from_start(const RunTrace& run, const Scene& scene);

/// u of the scalar itself; 0 for one that turned_round does not know.
Real roundoff_of(const std::string& scalar);

}  // namespace tps::properties::runs
