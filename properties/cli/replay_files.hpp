// tps properties --replay: cases of broken laws, asked again.
#pragma once

#include <string>
#include <vector>

#include "properties/explore/report.hpp"
#include "properties/implementation.hpp"

namespace tps::cli {

/// What the cases of these files give now. THROWS InputError where a file is none of regressions.
properties::Replayed replay_files(const std::vector<std::string>& paths, bool bitwise,
                                  properties::Implementation& subject);

}  // namespace tps::cli
