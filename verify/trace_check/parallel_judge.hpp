// Judges the segments of a trace on several threads, with the results of one.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

#include "verify/trace_check/judge_lines.hpp"
#include "verify/trace_check/segments.hpp"

namespace tps::check {

/// From the start of a trace, or from a full state and the number of its line; null where that is not
/// possible (judge_of_doubles, judge_of_wide).
using MakeJudge = std::function<std::unique_ptr<LineJudge>(std::string_view state, std::uint64_t number)>;

struct ParallelOptions {
  unsigned jobs = 2;                                   ///< threads, the caller's among them
  std::function<bool()> stop;                          ///< asked by all of them
  std::function<void(std::uint64_t events)> progress;  ///< called now and then, by the caller's
};

/// Judges all lines of a trace, and adds to `all` what one judge that goes through them has found
/// (docs/check.md, "Segments"). Throws what reading or judging throws.
void judge_in_parallel(Segments& segments, const MakeJudge& make, const ParallelOptions& options,
                       Judged& all);

}  // namespace tps::check
