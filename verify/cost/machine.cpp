#include "verify/cost/machine.hpp"

#include <fstream>

#include "reference/version.hpp"

namespace tps::cost {
namespace {

/// The line "model name : …" that Linux writes for the first processor.
std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown";
}

}  // namespace

Machine this_machine() {
#ifdef __clang__
  const std::string compiler = "clang++ " __VERSION__;
#else
  const std::string compiler = "g++ " __VERSION__;
#endif
  return {processor(), compiler, TPS_COST_FLAGS, std::string(version())};
}

}  // namespace tps::cost
