// What an inquiry can be narrowed to.
#pragma once

#include <string>
#include <vector>

namespace tps::properties::conform {

/// Each pattern names operations that there are: of known answers, of laws, or `simulate`. Throws
/// std::invalid_argument.
void check_operations(const std::vector<std::string>& patterns);

/// The same of strata, "block_time.graze", and of the rows of single steps. Throws std::invalid_argument.
void check_strata(const std::vector<std::string>& patterns);

}  // namespace tps::properties::conform
