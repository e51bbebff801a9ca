// The loop over the lines of a trace.
#pragma once

#include <functional>
#include <string_view>

#include "reference/engine/timing.hpp"
#include "reference/scene/scene.hpp"
#include "verify/trace_check/number.hpp"
#include "verify/trace_check/tally.hpp"

namespace tps::check {

/// Gives the next line behind the header; false at the end. A line that was too long is given as its
/// beginning.
struct LineSource {
  struct Text {
    std::string_view text;
    bool too_long = false;
  };
  std::function<bool(Text&)> next;
};

struct TraceFacts {
  const Scene& scene;
  Timing timing;
  bool minimal;
  int semantics;  ///< that the trace names; 0: none
};

/// Judges every line. Counts lines, events and states in the report.
template <typename Number>
void judge_lines(LineSource& source, const TraceFacts& facts, const Precision<Number>& precision,
                 Tally& tally, CheckReport& report);

/// For the scalars that are wider than double, by their names in trace headers.
void judge_wide_lines(LineSource& source, const TraceFacts& facts, std::string_view scalar, Tally& tally,
                      CheckReport& report);

}  // namespace tps::check
