// The first witness of a violation as a known-answer file.
#pragma once

#include <string>

#include "verify/trace_check/report.hpp"

namespace tps::check {

/// For each rule with a violation that is a step of one operation, the first one as a file of one case:
/// header and case, with the certified answer and its proof. `tps vectors verify` proves it, `tps eval OP
/// --in` replays it, and an implementation answers it like any other known-answer case. Empty where no
/// violation has such a step.
std::string witness_cases(const CheckReport& report);

}  // namespace tps::check
