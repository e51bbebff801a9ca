// One list of all operations: those of numbers (verify/eval/operations.hpp) and those of more than numbers
// (compound.hpp).
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tps::protocol {

struct Entry {
  std::string_view name;
  std::string_view part;  ///< of the system
  std::string_view page;  ///< of docs/
  bool is_answered;       ///< by answer(); the others `tps eval` has alone
};

/// Those of numbers in the order of the paper, then the others.
const std::vector<Entry>& catalogue();

/// Null for any other name.
const Entry* find_entry(std::string_view name);

}  // namespace tps::protocol
