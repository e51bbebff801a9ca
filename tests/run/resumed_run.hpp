// A run that is broken off and goes on.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "reference/run/resume.hpp"
#include "tests/run/traced_run.hpp"

namespace tps::testing {

struct ResumedRuns {
  RunSummary whole;
  std::vector<RunSummary> resumed;
};

/// Runs a scene, cuts its trace off behind a third, a half and nearly all of its bytes, and goes on from
/// each: every time the trace has to end as that of the whole run. Options as for run_scene, but for the
/// trace.
inline ResumedRuns expect_same_when_resumed(const Scene& scene, RunOptions options) {
  options.trace = scratch("whole.ndjson");
  ResumedRuns runs{run_scene(scene, options), {}};
  const std::string whole = read_bytes(options.trace);
  for (const std::size_t cut : {whole.size() / 3, whole.size() / 2, whole.size() - 900}) {
    write_bytes(options.trace, whole.substr(0, cut));
    runs.resumed.push_back(resume_run(options.trace, options));
    EXPECT_EQ(read_bytes(options.trace), whole) << cut;
  }
  std::filesystem::remove(options.trace);
  return runs;
}

}  // namespace tps::testing
