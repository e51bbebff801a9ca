// The page of a trace that the check has judged.
#pragma once

#include <string>

#include "verify/trace_check/report.hpp"

namespace tps::view {

/// Plays the trace and marks what the report objects to. `scene` is the scene file of a trace that lacks its
/// own, or empty. REQUIRES a file that can be read again. Throws InputError, and std::runtime_error where
/// this program has no viewer.
std::string checked_page(const std::string& trace, const std::string& scene,
                         const check::CheckReport& report);

}  // namespace tps::view
