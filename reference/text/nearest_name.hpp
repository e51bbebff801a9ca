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

/// The known name that was probably meant: one that a single edit makes of `name`, else the shortest that
/// begins with it or contains it ("theta" in "theta_revolve_deg"), else one that it begins with or contains,
/// else the one with the fewest edits. The first of equals; of many, only the first 200 are looked at. Empty
/// if nothing is known.
std::string nearest_name(std::string_view name, const std::vector<std::string>& known);

/// For messages about a name that is not known: "; did you mean X?" where the nearest one is a part of it,
/// has it as a part, or differs in at most a third of the characters; "." where none is that near, since a
/// wrong hint is worse than none.
std::string did_you_mean(std::string_view name, const std::vector<std::string>& known);

}  // namespace tps
