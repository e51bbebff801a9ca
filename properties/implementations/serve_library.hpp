// A shared library as a program that speaks the protocol.
#pragma once

#include <string>

namespace tps::properties {

/// Loads a library with the table of properties/c_abi/tps_implementation.h and answers requests on standard
/// input until it ends. A library that cannot be loaded answers hello with an error. @return the exit code.
int serve_library(const std::string& path);

}  // namespace tps::properties
