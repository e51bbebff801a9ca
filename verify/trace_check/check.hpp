// The trace check: is a run right and, if not, where did it first go wrong? (docs/check.md)
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "verify/trace_check/report.hpp"
#include "verify/trace_check/segment_size.hpp"

namespace tps::check {

struct CheckOptions {
  std::string scene;              ///< a scene file that the trace's own scene has to equal; empty: none
  double tolerance = 1;           ///< multiplies every derived bound
  bool trust_draws = false;       ///< recorded draws are taken as given, not asked of the generator
  std::uint64_t max_reports = 5;  ///< findings that are kept in full, for each rule
  /// Threads; 0: as many as there are processors. What is found does not depend on it, nor the report but
  /// for its seconds.
  unsigned jobs = 0;
  std::uint64_t segment_lines = kLinesOfSegment;  ///< at least, from full state to full state
  std::size_t segment_bytes = kBytesOfSegment;    ///< of a pipe that are kept of a segment, about
  const std::atomic<bool>* interrupt = nullptr;   ///< gives up, in good order, once it is true

  struct Progress {
    std::uint64_t bytes, events;  ///< read so far
  };
  std::function<void(const Progress&)> progress;  ///< called every few thousand lines
};

/// Judges every step of a trace from the trace's own previous state; "-" is the standard input.
///
/// Memory grows with the number of particles, the more the more jobs there are, and does not with the length
/// of the trace. Throws InputError where there is nothing to judge: no file, no header, a broken scene.
CheckReport check_trace(const std::string& path, const CheckOptions& options = {});

}  // namespace tps::check
