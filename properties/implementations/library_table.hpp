// The table of a shared library (properties/c_abi/tps_implementation.h), of any version that is known.
#pragma once

#include <string>
#include <vector>

#include "properties/c_abi/tps_implementation.h"

namespace tps::properties {

/// Loads a library for as long as the process lives. What the table's version does not have is not offered: a
/// null pointer. Throws std::runtime_error, which says what is wrong with the library.
tps_implementation library_table(const std::string& path);

/// The operations with a function in the table.
std::vector<std::string> operations_in(const tps_implementation& table);

}  // namespace tps::properties
