// What happens at the lines of somebody's trace, read no further than that takes.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>

#include "reference/scene/scene.hpp"

namespace tps::properties::conform {

/// By the number of the line, from 1: the kind of the event (phase for both of a phase), formed, load, drawn,
/// infinite mass, friction, end. A line that is no event has none.
std::map<std::uint64_t, std::set<std::string>> features_by_line(std::string_view trace, const Scene& scene);

}  // namespace tps::properties::conform
