// What a run says at its end, for people and for programs.
#pragma once

#include <string>

#include "reference/run/run.hpp"

namespace tps::cli {

std::string summary_text(const RunSummary& summary);
/// What happened, between which particles, and the remedy. REQUIRES that the run stalled.
std::string stall_message(const RunSummary& summary);
std::string summary_json(const RunSummary& summary);

}  // namespace tps::cli
