// What is instantiated for each scalar, in a file each (run_quad.cpp) so that a change of the engine compiles
// in parallel.
#pragma once

#include "reference/run/grouped_bodies.hpp"
#include "reference/run/run.hpp"

namespace tps {

struct ResumePoint;

/// run_in.hpp
template <typename Scalar>
RunSummary run_in(const Scene& scene, const RunOptions& options, const ResumePoint* resume);

/// grouped_bodies_in.hpp
template <typename Scalar>
GroupedVelocities group_in(const GroupedBodies& question);

}  // namespace tps
