// Everything that is asked, in order.
#pragma once

#include "properties/conform/inquiry.hpp"
#include "properties/conform/run_source.hpp"

namespace tps::properties::conform {

/// Known answers, single steps, laws and whole runs of everything that the subject offers. Throws
/// ProgramError where its answer to hello has features that there are not.
void ask_all(Implementation& subject, const Plan& plan, Verdict& verdict);

/// Whole runs of a simulator, on scenes with the plan's features.
void ask_simulator(RunSource source, const Plan& plan, Verdict& verdict);

}  // namespace tps::properties::conform
