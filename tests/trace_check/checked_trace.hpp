// What the check says of a trace that a test holds as text, and traces told otherwise in one line.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

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

/// Whether the report as people read it has that text.
inline bool says(const check::CheckReport& report, std::string_view text) {
  return report_text(report).find(text) != std::string::npos;
}

inline std::string first_finding(const check::CheckReport& report) {
  return report.findings.empty() ? "" : report.findings.front().message;
}

inline std::uint64_t violated(const check::CheckReport& report, check::Rule rule) {
  return report.of(rule).violated;
}

/// A trace with its line `which` of those that are meant changed; left out where the edit returns false.
template <typename IsMeant, typename Edit>
std::string with_changed(const TracedRun& run, IsMeant is_meant, int which, Edit edit) {
  std::string bytes;
  int seen = 0;
  for (const std::string& line : run.lines) {
    nlohmann::json event = nlohmann::json::parse(line);
    if (is_meant(event) && seen++ == which) {
      if (edit(event)) bytes += event.dump() + "\n";
    } else {
      bytes += line + "\n";
    }
  }
  return bytes;
}

/// The same of the lines that have a key.
template <typename Edit>
std::string with_line(const TracedRun& run, const char* key, int which, Edit edit) {
  return with_changed(
      run, [&](const nlohmann::json& event) { return event.contains(key); }, which,
      [&](nlohmann::json& event) {
        edit(event);
        return true;
      });
}

/// The same of the events of a kind; left out where the edit returns false.
template <typename Edit>
std::string with_event(const TracedRun& run, const std::string& kind, int which, Edit edit) {
  return with_changed(
      run, [&](const nlohmann::json& event) { return event.value("kind", "") == kind; }, which, edit);
}

}  // namespace tps::testing
