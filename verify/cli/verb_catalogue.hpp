// Which verbs a program has: its folders' (verify/cli/CMakeLists.txt).
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace tps::cli {

/// Registers every verb of this program.
void add_verbs(CLI::App& app, int& exit_code);

/// Verbs of the whole program that this one was built without.
const std::vector<std::string>& missing_verbs();

}  // namespace tps::cli
