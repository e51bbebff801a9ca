// The name that was probably meant.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace tps {

/// Edits (insert, delete, replace a character, swap two neighbours) that turn one name into the other;
/// only the first 64 characters of each are compared.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The known name with the fewest edits to `name`, the first of equals; of many, only the first 200 are
/// looked at. Empty if nothing is known.
std::string nearest_name(std::string_view name, const std::vector<std::string>& known);

}  // namespace tps
