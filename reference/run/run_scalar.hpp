// The instantiations of run_in, one file each so that a change of the engine compiles in parallel.
#pragma once

#include "reference/run/run.hpp"

namespace tps {

struct ResumePoint;

RunSummary run_float(const Scene& scene, const RunOptions& options, const ResumePoint* resume);
RunSummary run_double(const Scene& scene, const RunOptions& options, const ResumePoint* resume);
RunSummary run_long_double(const Scene& scene, const RunOptions& options, const ResumePoint* resume);
RunSummary run_quad(const Scene& scene, const RunOptions& options, const ResumePoint* resume);
RunSummary run_mp50(const Scene& scene, const RunOptions& options, const ResumePoint* resume);
RunSummary run_mp100(const Scene& scene, const RunOptions& options, const ResumePoint* resume);

}  // namespace tps
