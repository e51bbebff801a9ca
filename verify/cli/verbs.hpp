// The verbs of the program. Each function registers one with its options; its callback sets the exit code.
#pragma once

#include <CLI/CLI.hpp>

namespace tps::cli {

void add_run(CLI::App& app, int& exit_code);
void add_check(CLI::App& app, int& exit_code);
void add_explain(CLI::App& app, int& exit_code);
void add_scene(CLI::App& app, int& exit_code);
void add_import(CLI::App& app, int& exit_code);
void add_draw(CLI::App& app, int& exit_code);
void add_claims(CLI::App& app, int& exit_code);
void add_eval(CLI::App& app, int& exit_code);
void add_vectors(CLI::App& app, int& exit_code);
void add_serve(CLI::App& app, int& exit_code);

/// Whether "--" stands on the command line: CLI11 does not tell.
enum class Dashes { none, there };
Dashes dashes_in(int argc, const char* const* argv);

void add_properties(CLI::App& app, int& exit_code, Dashes dashes);

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
