// What a run says at its end, for people and for programs.
#pragma once

#include <string>

#include "reference/run/run.hpp"

namespace tps::cli {

std::string summary_text(const RunSummary& summary);
/// What happened, between which particles, and the remedy. REQUIRES that the run stalled.
std::string stall_message(const RunSummary& summary);
/// Which number left the range, and the remedy. REQUIRES that the run left it.
std::string range_message(const RunSummary& summary);
/// How many collisions rounding alone can have made, from which on, and the remedy; empty where there are
/// none.
std::string rounding_note(const RunSummary& summary);
/// Whether energy and momentum are what the ledger accounts for, within its bounds.
bool conserves(const RunSummary& summary);
std::string summary_json(const RunSummary& summary);

}  // namespace tps::cli
