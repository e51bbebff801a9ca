// A reply as `tps eval` shows it.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "verify/operations/report.hpp"

namespace tps::protocol {

/// A result as a report for people: a line for each number, vector and word in it.
operations::Report report_of(const nlohmann::ordered_json& out);

}  // namespace tps::protocol
