// Values of a scene file that the schema has accepted: a required key is there, with its type.
#pragma once

#include <string_view>

#include "reference/text/json_number.hpp"

namespace tps {

inline double number_at(const JsonValue& object, std::string_view key) {
  return json_number(*object.find(key)).value();
}

inline double number_or(const JsonValue& object, std::string_view key, double otherwise) {
  return object.find(key) == nullptr ? otherwise : number_at(object, key);
}

inline int integer_of(const JsonValue& value) {
  return static_cast<int>(value.number()->value);
}

}  // namespace tps
