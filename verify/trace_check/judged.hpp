// What judging some lines of a trace in a row has come to: those of a segment, or all so far.
#pragma once

#include <cstdint>

#include "verify/trace_check/below_rounding.hpp"
#include "verify/trace_check/decimal_digits.hpp"
#include "verify/trace_check/report.hpp"
#include "verify/trace_check/tally.hpp"
#include "verify/trace_check/trace_facts.hpp"

namespace tps::check {

class Judged {
 public:
  /// `begun`: what is known of the trace before any line of it.
  Judged(CheckReport begun, std::uint64_t max_reports)
      : report(std::move(begun)), tally(report, report.tolerance, max_reports) {}
  Judged(const Judged&) = delete;
  Judged& operator=(const Judged&) = delete;

  CheckReport report;
  Tally tally;
  DecimalDigits digits;
  BelowRounding below_rounding;
  bool has_draws = false;
  bool begins_with_state = false;
  std::uint64_t last_state = 0;  ///< behind which event, counted in lines

  /// Law: as if the lines of `later`, which follow, had been judged here.
  void take_over(const Judged& later);
  /// After the last line: what concerns the trace as a whole.
  void close(const TraceFacts& facts);

 private:
  void say_missing_states();
};

}  // namespace tps::check
