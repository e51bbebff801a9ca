// The instantiations of run_in and group_in, one file each so that a change of the engine compiles in
// parallel.
#pragma once

#include "reference/run/grouped_bodies.hpp"
#include "reference/run/run.hpp"

namespace tps {

struct ResumePoint;

RunSummary run_float(const Scene& scene, const RunOptions& options, const ResumePoint* resume);
RunSummary run_double(const Scene& scene, const RunOptions& options, const ResumePoint* resume);
RunSummary run_long_double(const Scene& scene, const RunOptions& options, const ResumePoint* resume);
RunSummary run_quad(const Scene& scene, const RunOptions& options, const ResumePoint* resume);
RunSummary run_mp50(const Scene& scene, const RunOptions& options, const ResumePoint* resume);
RunSummary run_mp100(const Scene& scene, const RunOptions& options, const ResumePoint* resume);

GroupedVelocities group_float(const GroupedBodies& question);
GroupedVelocities group_double(const GroupedBodies& question);
GroupedVelocities group_long_double(const GroupedBodies& question);
GroupedVelocities group_quad(const GroupedBodies& question);
GroupedVelocities group_mp50(const GroupedBodies& question);
GroupedVelocities group_mp100(const GroupedBodies& question);

}  // namespace tps
