// Commands as processes.
#pragma once

#include <cstdio>
#include <string>

namespace tps {

struct Outcome {
  int exit_code;
  std::string text;  ///< standard output and errors
};

inline Outcome run_shell(const std::string& command) {
  FILE* pipe = popen(("{ " + command + "; } 2>&1").c_str(), "r");
  if (pipe == nullptr) return {-1, "no pipe"};
  std::string text;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) text.push_back(static_cast<char>(c));
  const int status = pclose(pipe);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text};
}

/// Runs `tps eval ARGUMENTS` with this standard input. REQUIRES input without single quotes.
inline Outcome run_eval(const std::string& arguments, const std::string& input = "") {
  return run_shell("printf '%s' '" + input + "' | " TPS_PROGRAM " eval " + arguments);
}

}  // namespace tps
