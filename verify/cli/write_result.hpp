// Results on standard output, with nothing lost silently.
#pragma once

#include <string>
#include <string_view>

namespace tps::cli {

/// Writes a whole result to a file, "-" being standard output. Throws OutputError. Files of a call that also
/// reads or writes others are made distinct first (named_files.hpp).
void write_result(const std::string& path, std::string_view text);

}  // namespace tps::cli
