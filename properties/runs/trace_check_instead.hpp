// `tps check` as the judge of traces that laws of runs cannot judge.
#pragma once

#include <optional>
#include <string>

#include "properties/runs/laws.hpp"
#include "reference/text/scratch_file.hpp"
#include "verify/trace_check/check.hpp"

namespace tps::properties::runs {

inline Instead check_instead() {
  Instead instead;
  instead.fault_in = [](const std::string& trace) -> std::optional<std::string> {
    const ScratchFile file(trace);
    const check::CheckReport report = check::check_trace(file.path());
    if (report.conforming()) return std::nullopt;
    for (const check::Finding& finding : report.findings) {
      if (finding.outcome == check::Outcome::violated)
        return "line " + std::to_string(finding.line) + ": " + finding.message;
    }
    return "the check does not call it conforming";
  };
  return instead;
}

}  // namespace tps::properties::runs
