// Results on standard output, with nothing lost silently.
#pragma once

#include <string>
#include <string_view>

namespace tps::cli {

/// Writes a whole result to a file, "-" being standard output. Throws OutputError.
void write_result(const std::string& path, std::string_view text);

}  // namespace tps::cli
