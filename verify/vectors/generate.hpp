// Known-answer files, written.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "verify/vectors/stratum.hpp"

namespace tps::vectors {

constexpr int kVectorsVersion = 1;
constexpr std::uint64_t kCommittedSeed = 20261122;
/// Cases of level 1 in a file: the first ones.
constexpr int kSmokeCases = 10;

/// How much of which stratum: `count` cases from number `first` on.
struct Extent {
  std::uint64_t first = 0;
  std::uint64_t count = 0;
};

/// The extent of a level: 1 the first cases, 2 what is committed, 3 the `count` cases behind it.
Extent extent_of(const Stratum& stratum, int level, std::uint64_t count_at_level_3);

/// The header line of a file, with its newline.
std::string header_line(const Stratum& stratum, std::uint64_t seed, const Extent& extent);

/// One case. A function of seed, stratum and number alone.
Json case_object(const Stratum& stratum, std::uint64_t seed, std::uint64_t number);

/// Its line, with its newline. A function of seed, stratum and number alone.
std::string case_line(const Stratum& stratum, std::uint64_t seed, std::uint64_t number);

/// A whole file, given to `write` line by line.
void write_stratum(const Stratum& stratum, std::uint64_t seed, const Extent& extent,
                   const std::function<void(std::string_view)>& write);

}  // namespace tps::vectors
