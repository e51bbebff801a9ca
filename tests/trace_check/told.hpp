// What the check makes of a trace that is told as it was, or otherwise.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "tests/trace_check/checked_trace.hpp"
#include "tests/trace_check/edits.hpp"
#include "verify/trace_check/check.hpp"

namespace tps::mutation {

inline check::CheckReport checked(const Trace& trace) {
  return testing::checked(text_of(trace));
}

inline std::string first_of(const check::CheckReport& report) {
  std::string text;
  for (const check::Finding& f : report.findings) {
    text += std::string(name(f.rule)) + (f.outcome == check::Outcome::undecided ? "? " : ": ") + "event " +
            std::to_string(f.event) + ": " + f.message + "\n";
  }
  return text;
}

/// Counts what was told, so that no test is empty.
struct Told {
  int honest = 0, lies = 0;
};

/// A trace and what is to be thought of it.
inline void expect_honest(const Trace& trace, Told& told, const std::string& what) {
  const check::CheckReport report = checked(trace);
  ++told.honest;
  EXPECT_EQ(report.violated() + report.undecided(), 0U) << what << '\n'
                                                        << first_of(report) << text_of(trace).substr(0, 4000);
}
inline void expect_lie(const Trace& trace, Told& told, const std::string& what) {
  const check::CheckReport report = checked(trace);
  ++told.lies;
  EXPECT_GT(report.violated(), 0U) << what << '\n' << text_of(trace).substr(0, 4000);
}

}  // namespace tps::mutation
