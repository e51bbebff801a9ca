// JSON as a tree in which every value knows its line.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "reference/text/input_error.hpp"

namespace tps {

/// A number of a JSON text as the nearest double.
struct JsonNumber {
  enum class Integer { none, natural, negative };

  double value = 0;
  bool rounded_integer = false;     ///< written as an integer that no double has
  Integer integer = Integer::none;  ///< written as an integer of 64 bits: then `magnitude` is exact
  std::uint64_t magnitude = 0;
};

struct JsonMember;

/// A value and the line on which it begins.
struct JsonValue {
  using Array = std::vector<JsonValue>;
  using Object = std::vector<JsonMember>;  ///< in the order of the file

  std::variant<std::monostate, bool, JsonNumber, std::string, Array, Object> data;
  std::uint32_t line = 0;

  bool is_null() const { return std::holds_alternative<std::monostate>(data); }
  const bool* boolean() const { return std::get_if<bool>(&data); }
  const JsonNumber* number() const { return std::get_if<JsonNumber>(&data); }
  const std::string* string() const { return std::get_if<std::string>(&data); }
  const Array* array() const { return std::get_if<Array>(&data); }
  const Object* object() const { return std::get_if<Object>(&data); }

  /// The member of that name (the first, if the file has it twice); null if there is none, or if this is
  /// not an object.
  const JsonValue* find(std::string_view key) const;
};

struct JsonMember {
  std::string key;
  std::uint32_t key_line = 0;
  JsonValue value;
};

/// What a text may cost at most. The defaults are for files of people: a scene, a report.
struct JsonLimits {
  std::size_t max_bytes = std::size_t{64} << 20;
  std::size_t max_depth = 64;          ///< of lists and objects inside each other
  std::size_t max_key = 1000;          ///< bytes of a key: every message below it names it
  std::size_t max_values = 4'000'000;  ///< of all kinds; about 60 bytes of memory each, 120 while lists grow
};

struct JsonDocument {
  JsonValue root;
  InputProblems problems;  ///< keys that stand twice in an object: the tree is whole, but not to be used
};

/// Parses a whole text (RFC 8259, UTF-8 without byte order mark). `name` is what messages call the file,
/// `first_line` the number of the text's first line (of a line-oriented file).
/// Throws InputError where no tree can be built: syntax, encoding, a number beyond the largest double, NaN
/// and Infinity, a limit exceeded.
JsonDocument parse_json(std::string_view text, const std::string& name, const JsonLimits& limits = {},
                        std::size_t first_line = 1);

/// Reads and parses a file; "-" is the standard input. `remedy` ends the message about a file that is too
/// large. Throws InputError.
JsonDocument parse_json_file(const std::string& path, const std::string& remedy,
                             const JsonLimits& limits = {});

}  // namespace tps
