// The numbers that an operation is evaluated on, read and checked.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "verify/eval/operations.hpp"

namespace tps::eval {

/// Doubles by key; each vector has `dimension` components, everything else has one.
struct Input {
  int dimension = 0;
  std::map<std::string, std::vector<double>> values;
};

/// Reads "key=value" words: decimals (the nearest double), hexadecimal floats (exact), "inf"; the components
/// of a vector with commas between them. Throws InputError with everything that is wrong.
Input read_words(const Operation& operation, const std::vector<std::string>& words);

/// Reads the object that the protocol calls "in", or a whole request that has it; "-" is standard input.
/// Throws InputError with everything that is wrong.
Input read_json(const Operation& operation, const std::string& path);

}  // namespace tps::eval
