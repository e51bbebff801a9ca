// The paper's presynaptic terminal at three seeds.
#pragma once

#include <array>
#include <cstdint>

#include "reference/run/run.hpp"

namespace tps::claims {

inline constexpr std::array<std::uint64_t, 3> kTerminalSeeds{1, 2, 3};

/// The run of the default terminal with a seed, in double. Runs once a process and seed.
const RunSummary& terminal_run(std::uint64_t seed);

}  // namespace tps::claims
