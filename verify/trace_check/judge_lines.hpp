// The judge of lines of a trace in a row.
#pragma once

#include <cstdint>
#include <memory>
#include <string_view>

#include "verify/trace_check/judged.hpp"
#include "verify/trace_check/line_text.hpp"

namespace tps::check {

/// Judges lines one after the other, each from what the ones before it have left.
class LineJudge {
 public:
  virtual ~LineJudge() = default;

  /// `number`: of the line in the trace.
  virtual void judge(const LineText& line, std::uint64_t number) = 0;
  /// Where the line just judged is a full state from which nothing but itself and the header is needed to go
  /// on: ends the segment there and goes on with the next one. @return what the segment came to; null, and
  /// nothing changes, where that cannot be
  virtual std::unique_ptr<Judged> end_segment() = 0;
  /// Whether a verdict on this segment hung on what the one before it did, which this judge has not seen.
  virtual bool needed_before() const = 0;
  /// The trace is over. @return what has come of it since the last segment ended
  virtual std::unique_ptr<Judged> close(std::uint64_t lines) = 0;
};

/// What a judge is made from. `begun` is what a report begins with, all rules at 0.
struct JudgeParts {
  TraceFacts facts;
  CheckReport begun;
  std::uint64_t max_reports = 0;
};

/// From the start of a trace or, where a line with a full state is given, from that; the line is judged by
/// who comes to it. @return null where it is no such line, or not enough to go on from; `number` is its own
std::unique_ptr<LineJudge> judge_of_doubles(const JudgeParts& parts, bool is_float, std::string_view state,
                                            std::uint64_t number);
/// The same for the scalars that are wider than double, by their names in trace headers.
std::unique_ptr<LineJudge> judge_of_wide(const JudgeParts& parts, std::string_view scalar,
                                         std::string_view state, std::uint64_t number);

}  // namespace tps::check
