// A line of a trace as it was read.
#pragma once

#include <string_view>

namespace tps::check {

/// One that was too long is given as its beginning.
struct LineText {
  std::string_view text;
  bool too_long = false;
};

}  // namespace tps::check
