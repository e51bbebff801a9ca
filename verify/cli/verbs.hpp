// What every verb shares: exit codes, and the command line that CLI11 does not tell.
#pragma once

#include <CLI/CLI.hpp>

namespace tps::cli {

/// Whether "--" stands on the command line.
bool command_line_has_dashes();

/// For transform() of the option that takes the words behind "--": as they were typed. CLI11 takes "[a,b]"
/// for two words, so that such a word reaches it with a mark before it.
std::string as_typed(std::string word);

/// What the program returns to the shell (--help lists the same).
enum ExitCode : int {
  kDone = 0,
  kViolation = 1,
  kUsage = 2,
  kBadInput = 3,
  kOtherProgram = 4,
  kUndecided = 5,
  kStalled = 6,
  kOutputFailed = 7,
  kOutOfRange = 8,
  kInternal = 70,
  kInterrupted = 130,
};

}  // namespace tps::cli
