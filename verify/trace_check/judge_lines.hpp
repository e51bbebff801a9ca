// The loop over the lines of a trace.
#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "verify/trace_check/number.hpp"
#include "verify/trace_check/tally.hpp"
#include "verify/trace_check/trace_facts.hpp"

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

/// One way to take a trace, and where its verdicts go.
struct Judgement {
  TraceFacts facts;
  Tally& tally;
  CheckReport& report;
};

/// Judges every line in each of the ways. Counts events and states in the reports; lines are counted in the
/// first one, by the source.
template <typename Number>
void judge_lines(LineSource& source, const std::vector<Judgement>& ways, const Precision<Number>& precision);

/// For the scalars that are wider than double, by their names in trace headers.
void judge_wide_lines(LineSource& source, const std::vector<Judgement>& ways, std::string_view scalar);

}  // namespace tps::check
