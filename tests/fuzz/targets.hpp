// What is fuzzed: every reader of other people's bytes, by name.
#pragma once

#include <string_view>
#include <vector>

namespace tps::fuzz {

/// Feeds bytes to a reader. Returns whatever the verdict; throws std::logic_error, or ends in a sanitizer,
/// where the reader breaks a promise.
struct Target {
  std::string_view name;  ///< of its folder of seeds, tests/fuzz/corpus/NAME
  void (*feed)(std::string_view bytes);
};

const std::vector<Target>& targets();

/// Null for an unknown name.
const Target* find_target(std::string_view name);

}  // namespace tps::fuzz
