// Where in a document: a chain of keys and places that is turned into text only when somebody asks.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "reference/text/json_document.hpp"

namespace tps {

/// A step into a value; lives on the stack of the recursion that walks the document.
class JsonPath {
 public:
  /// The document itself, or the place `prefix` (a JSON pointer) of a larger one.
  explicit JsonPath(std::string_view prefix = "") : key_(prefix) {}

  JsonPath key(std::string_view name) const { return JsonPath(this, name, no_index); }
  JsonPath item(std::size_t index) const { return JsonPath(this, {}, index); }

  /// As a JSON pointer (RFC 6901).
  std::string text() const;

 private:
  static constexpr std::size_t no_index = static_cast<std::size_t>(-1);
  JsonPath(const JsonPath* parent, std::string_view key, std::size_t index)
      : parent_(parent), key_(key), index_(index) {}

  const JsonPath* parent_ = nullptr;
  std::string_view key_;
  std::size_t index_ = no_index;
};

/// A key as a step of a JSON pointer: '~' is written "~0", '/' "~1".
std::string escape_pointer_key(std::string_view key);

/// The value at `pointer`, or the innermost one on the way that exists.
const JsonValue& resolve_pointer(const JsonValue& root, std::string_view pointer);

}  // namespace tps
