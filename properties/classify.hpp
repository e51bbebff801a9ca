// What a case is, seen from the exact answers: reported as hit counts, of which tests demand floors.
#pragma once

#include <string>
#include <vector>

#include "properties/case.hpp"
#include "reference/equations/timing_query.hpp"
#include "reference/equations/timing_verdict.hpp"

namespace tps::properties {

/// What the generator aimed at; and where the case has a pair and a limit, the exact verdicts of both
/// queries, such as "block tangent" and "tether taut".
std::vector<std::string> hazards_of(const Case& c);

/// Every verdict that a query of the kind can get (docs/protocol.md, "Operations").
std::vector<TimingVerdict> verdicts_of(TimingKind kind);

/// Every verdict that hazards_of() can say.
std::vector<std::string> verdict_hazards();

}  // namespace tps::properties
