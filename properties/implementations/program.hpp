// Anybody's implementation in another process: a command that speaks the protocol, or a shared library that a
// child of ours loads, so that its crashes are its own.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "properties/implementation.hpp"

namespace tps::properties {

/// The program cannot be started, or its answer to hello is none.
class ProgramError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct ProgramOptions {
  std::chrono::milliseconds timeout{5000};  ///< for each reply
  std::optional<int> bits;                  ///< else as hello says ("bits"), else 53
};

/// After so many replies that did not come in time a program is given up, and after so many other failures in
/// a row, too: a timeout each would take half an hour to say the same of every law.
constexpr int kMostHangs = 5;
constexpr int kMostFailuresInARow = 200;

/// Started now, and again after each failure. Throws ProgramError. REQUIRES words, the first not empty.
std::unique_ptr<Implementation> command(const std::vector<std::string>& words, const ProgramOptions& options);

/// The same for a library (properties/c_abi/tps_implementation.h). Throws ProgramError.
std::unique_ptr<Implementation> shared_library(const std::string& path, const ProgramOptions& options);

}  // namespace tps::properties
