// Members of a study that its schema promises.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace tps::cost {

inline std::string text_at(const nlohmann::ordered_json& value, const char* key) {
  return value.at(key).get<std::string>();
}

inline double number_at(const nlohmann::ordered_json& value, const char* key) {
  return value.at(key).get<double>();
}

}  // namespace tps::cost
