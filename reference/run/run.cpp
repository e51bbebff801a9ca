#include "reference/run/run.hpp"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>

#include "reference/run/resume.hpp"
#include "reference/run/run_scalar.hpp"
#include "reference/run/trace_file.hpp"
#include "reference/scalars.hpp"
#include "reference/text/input_error.hpp"
#include "reference/text/output.hpp"
#include "reference/version.hpp"

namespace tps {

const std::vector<std::string>& timing_names() {
  static const std::vector<std::string> names = {"paper", "stable", "certified"};
  return names;
}

std::optional<Timing> timing_named(std::string_view name) {
  const auto found = std::find(timing_names().begin(), timing_names().end(), name);
  if (found == timing_names().end()) return std::nullopt;
  return static_cast<Timing>(found - timing_names().begin());
}

const std::vector<std::string>& detector_names() {
  static const std::vector<std::string> names = {"automatic", "all-pairs", "cells"};
  return names;
}

std::optional<DetectorKind> detector_named(std::string_view name) {
  const auto found = std::find(detector_names().begin(), detector_names().end(), name);
  if (found == detector_names().end()) return std::nullopt;
  return static_cast<DetectorKind>(found - detector_names().begin());
}

bool can_be_timed(ScalarKind scalar, Timing timing) {
  return timing != Timing::certified || scalar == ScalarKind::float_ || scalar == ScalarKind::double_;
}

std::uint64_t default_state_every(const Scene& scene) {
  return std::max<std::uint64_t>(1000, 10 * scene.particles.size());
}

namespace {

void require_same_run(const std::string& checkpoint, const TraceHead& head, const std::string& trace) {
  const TraceHead other = read_trace_head(trace);
  if (other.scene == head.scene && other.scalar == head.scalar && other.timing == head.timing &&
      other.state_every == head.state_every) {
    return;
  }
  throw InputError(
      {{trace, 1, "",
        "is the trace of another run than the checkpoint '" + checkpoint +
            "' (scene, scalar, timing or state_every differ); give its own trace, or another file name "
            "with --resume and the trace itself"}});
}

RunSummary run_any(const Scene& scene, const RunOptions& options, const ResumePoint* resume) {
  return AllScalars::with<RunSummary>(
      options.scalar, [&]<typename Scalar>() { return run_in<Scalar>(scene, options, resume); });
}

}  // namespace

RunSummary run_scene(const Scene& scene, const RunOptions& options) {
  return run_any(scene, options, nullptr);
}

RunSummary resume_run(const std::string& path, const RunOptions& options) {
  bool ignored = false;
  return resume_run(path, options, ignored);
}

RunSummary resume_run(const std::string& path, const RunOptions& options, bool& unprotected) {
  const TraceHead head = read_trace_head(path);
  if (head.semantics != kSemanticsVersion) {
    throw InputError(
        {{path, 1, "",
          "is of semantics " + std::to_string(head.semantics) + " and would go on by " +
              std::to_string(kSemanticsVersion) +
              ", as no uninterrupted run does (docs/decisions.md); run its scene again from the start"}});
  }
  RunOptions resumed = options;
  resumed.scalar = head.scalar;
  resumed.timing = head.timing;
  resumed.state_every = head.state_every;
  // A trace that is still being written may grow faster than it is read.
  std::shared_ptr<Output> held;
  std::error_code ignored;
  if (std::filesystem::is_regular_file(options.trace, ignored))
    held = std::make_shared<Output>(options.trace, Output::Reserve::only);
  ResumePoint point = last_state(path);
  point.trace = std::move(held);
  unprotected = point.state.checksum == StateData::Checksum::absent;
  if (is_checkpoint(path) && !options.trace.empty()) {
    require_same_run(path, head, options.trace);
    point.from = options.trace;
    point.keep = place_behind_state(options.trace, point.state.k);
  }
  try {
    return run_any(head.scene, resumed, &point);
  } catch (const StateDoesNotFit& problem) {
    throw InputError({{path, 0, "",
                       std::string("its last full state does not fit its scene: ") + problem.what() +
                           "; cut the file off before that line, or start the run again"}});
  }
}

}  // namespace tps
