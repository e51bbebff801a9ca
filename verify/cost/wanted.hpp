// Which parts of a study somebody wants.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace tps::cost {

/// Nobody's list is everything.
inline bool is_wanted(const std::vector<std::string>& names, const std::string& name) {
  return names.empty() || std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace tps::cost
