// Going on from a file, and what there is to say about it.
#pragma once

#include <string>

#include "reference/run/run.hpp"

namespace tps {

/// resume_run (run.hpp); `unprotected` becomes true where the full state that the run went on from has no
/// checksum, so that nothing would have shown damage.
RunSummary resume_run(const std::string& path, const RunOptions& options, bool& unprotected);

/// The checksum that a first line carries: of what its run depends on (scalar, timing, state_every, scene),
/// as the program spells it. Spaces, the order of keys and the version do not matter.
std::string head_checksum(const TraceHead& head);

/// Semantics that a file may name.
bool is_known_semantics(double version);

}  // namespace tps
