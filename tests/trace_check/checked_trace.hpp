// What the check says of a trace that a test holds as text, and traces told otherwise in one line.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/run/traced_run.hpp"
#include "verify/trace_check/check.hpp"

namespace tps::testing {

inline check::CheckReport checked(const std::string& bytes, const check::CheckOptions& options = {}) {
  const std::string path = scratch("checked.ndjson");
  write_bytes(path, bytes);
  const check::CheckReport report = check::check_trace(path, options);
  std::filesystem::remove(path);
  return report;
}

inline std::string first_finding(const check::CheckReport& report) {
  return report.findings.empty() ? "" : report.findings.front().message;
}

/// A trace with its line `which` of those that have the key changed.
template <typename Edit>
std::string with_line(const TracedRun& run, const char* key, int which, Edit edit) {
  std::string bytes;
  int seen = 0;
  for (const std::string& line : run.lines) {
    nlohmann::json event = nlohmann::json::parse(line);
    if (event.contains(key) && seen++ == which) {
      edit(event);
      bytes += event.dump() + "\n";
    } else {
      bytes += line + "\n";
    }
  }
  return bytes;
}

}  // namespace tps::testing
