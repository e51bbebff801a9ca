// The trace check accepts the runs of generated scenes. Apart from the laws, which share no code with it.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "properties/runs/scenes.hpp"
#include "properties/runs/scratch_file.hpp"
#include "properties/runs/simulator.hpp"
#include "verify/trace_check/check.hpp"

namespace tps::properties::runs {
namespace {

std::string first_of(const check::CheckReport& report) {
  for (const check::Finding& finding : report.findings) {
    if (finding.outcome == check::Outcome::violated)
      return "line " + std::to_string(finding.line) + ": " + finding.message;
  }
  return "no finding";
}

void accept(const std::string& timing) {
  // The check takes a moving infinite mass from where it exactly is, a run from where it is rounded to: far
  // from the origin a bounce off it then differs by more than the check's 12 ulp.
  Wanted wanted;
  wanted.infinite_masses = false;
  const SmallScene small = *small_scene(wanted);
  const auto simulator = reference_simulator("double", timing);
  const ScratchFile trace(simulator->simulate(small.scene, {.max_events = 60, .state_every = 13}));
  const check::CheckReport report = check::check_trace(trace.path());
  if (!report.conforming()) RC_FAIL(first_of(report));
}

RC_GTEST_PROP(CheckedRuns, ConformInDouble, ()) {
  accept("stable");
}
RC_GTEST_PROP(CheckedRuns, ConformCertified, ()) {
  accept("certified");
}
}  // namespace
}  // namespace tps::properties::runs
