// What a program wrote, in words for a message.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace tps::properties {

/// One line, whatever the bytes.
std::string shown(std::string_view text, std::size_t most);

/// The last lines of a text, whole as long as they fit, in one line. `begins` says whether the text begins
/// with a line.
std::string last_lines(std::string_view text, bool begins);

}  // namespace tps::properties
