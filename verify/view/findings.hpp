// What the trace check objects to, as a page shows it: beside what was found what should have been.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "verify/trace_check/report.hpp"
#include "verify/view/playback.hpp"

namespace tps::view {

/// A vector at a particle that the equations give.
struct Expected {
  int particle = 0;     ///< index into the scene
  std::string_view of;  ///< "dp" or "velocity", the latter after the event
  Coordinates value{};
};

struct ShownFinding {
  check::Finding finding;
  std::vector<Expected> expected;  ///< empty where the finding is of no vector
};

/// The findings of a report, the first `kMostShown`, with the certified answers of those that are a step of
/// one operation.
std::vector<ShownFinding> shown_findings(const check::CheckReport& report, const Scene& scene);

inline constexpr std::size_t kMostShown = 200;

/// The lines of a trace that they are at, ascending.
std::vector<std::uint64_t> lines_of(const check::CheckReport& report);

}  // namespace tps::view
