// One target as libFuzzer calls it; TPS_FUZZ_TARGET is its name.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>

#include "tests/fuzz/targets.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const tps::fuzz::Target& target = *tps::fuzz::find_target(TPS_FUZZ_TARGET);
  try {
    target.feed({reinterpret_cast<const char*>(data), size});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    std::abort();
  }
  return 0;
}
