// What two species do to each other, as an entry of "pairs" or "phases" says it.
#pragma once

#include <utility>
#include <vector>

#include "reference/scene/scene.hpp"
#include "reference/text/json_document.hpp"

namespace tps {

// REQUIRE values that the schema has accepted.

FormRule read_form(const JsonValue& value);
BreakRule read_break(const JsonValue& value);

/// Distances that are left out are the sum of the radii of the pair, and their difference.
PairLaw read_pair_law(const JsonValue& entry, const std::vector<Species>& species, std::pair<int, int> pair);

}  // namespace tps
