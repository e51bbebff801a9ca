// Damaged documents: what disks, editors and enemies do to a good one.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace tps::fuzz {

/// One to four of: a byte changed, a piece deleted, doubled, moved or cut off, a word of the dictionary put
/// in or in the place of another value. Depends on the generator's state alone.
std::string damaged(std::string text, const std::vector<std::string>& dictionary, std::mt19937_64& random);

}  // namespace tps::fuzz
