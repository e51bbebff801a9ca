// tps properties --runs: laws of whole runs, asked of the reference or of a command that simulates as `tps
// run` does.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

namespace tps::cli {

struct RunLawQuestions {
  std::vector<std::string> patterns;  ///< names or numbers; none for all
  std::string scalar = "double", timing = "stable";
  std::uint64_t cases = 100;  ///< generated scenes a law
  std::uint64_t seed = 0;
  std::chrono::milliseconds timeout{60'000};  ///< for each run of the command
  std::vector<std::string> command;           ///< empty: the reference
};

/// The laws, and the hazards that generated scenes meet, as tables of Markdown.
std::string table_of_run_laws();
std::string table_of_hazards();

/// Prints what becomes of each law; the exit code. THROWS CLI::ValidationError where no law is called so.
int ask_run_laws(const RunLawQuestions& questions);

}  // namespace tps::cli
