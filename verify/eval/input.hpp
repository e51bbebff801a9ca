// The numbers that an operation is evaluated on, read and checked.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "reference/text/json_document.hpp"
#include "verify/eval/operations.hpp"

namespace tps::eval {

/// Doubles by key; each vector has `dimension` components, everything else has one.
struct Input {
  int dimension = 0;
  std::map<std::string, std::vector<double>> values;
};

/// Reads "key=value" words: decimals (the nearest double), hexadecimal floats (exact), "inf"; the components
/// of a vector with commas between them. Throws InputError with everything that is wrong.
Input read_words(const Operation& operation, const std::vector<std::string>& words,
                 const std::string& source = "command line");

/// Reads the object that the protocol calls "in", or a whole request that has it; "-" is standard input.
/// Throws InputError with everything that is wrong.
Input read_json(const Operation& operation, const std::string& path);

/// The same of a value inside another document: `source` and `pointer` say where it stands in messages.
Input read_value(const Operation& operation, const JsonValue& object, const std::string& source,
                 const std::string& pointer);

/// The same for any object of numbers with the given keys (their domains are those of operations), which
/// messages call `name`. The key `other_key` is the caller's and may be there, too.
Input read_object(std::string_view name, const std::vector<std::string>& keys, const JsonValue& object,
                  const std::string& source, const std::string& pointer, std::string_view other_key);

}  // namespace tps::eval
