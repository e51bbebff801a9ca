// Any scene that is accepted runs, and its run conforms.
#pragma once

#include <string_view>

namespace tps::fuzz {

/// Reads a scene; where it is accepted and small, runs 200 events of it and checks the trace. Throws
/// std::logic_error with the check's report where a rule is violated.
void run_and_check(std::string_view bytes);

}  // namespace tps::fuzz
