// The numbers that an operation is evaluated on, read and checked.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "reference/text/json_document.hpp"
#include "verify/operations/catalogue.hpp"

namespace tps::operations {

/// Doubles by key; each vector has `dimension` components, everything else has one.
struct Input {
  int dimension = 0;
  std::map<std::string, std::vector<double>> values;
};

/// Reads "key=value" words: decimals (the nearest double), hexadecimal floats (exact), "inf"; the components
/// of a vector with commas between them. Throws InputError with everything that is wrong.
Input read_words(const Operation& operation, const std::vector<std::string>& words,
                 const std::string& source = "command line");

/// Where a value of JSON stands, for messages.
struct Place {
  const std::string& source;
  std::string pointer;
};

/// The same of a value of JSON: the object that the protocol calls "in".
Input read_value(const Operation& operation, const JsonValue& object, const Place& place);

/// The same for any object of numbers with the given keys (their domains are those of operations), which
/// messages call `name`. The key `other_key` is the caller's and may be there, too.
Input read_object(std::string_view name, const std::vector<std::string>& keys, const JsonValue& object,
                  const Place& place, std::string_view other_key);

}  // namespace tps::operations
