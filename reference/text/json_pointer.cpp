#include "reference/text/json_pointer.hpp"

#include <algorithm>
#include <charconv>

namespace tps {
namespace {

std::string unescape(std::string_view step) {
  std::string key;
  for (std::size_t k = 0; k < step.size(); ++k) {
    if (step[k] == '~' && k + 1 < step.size()) {
      key += step[++k] == '1' ? '/' : '~';
    } else {
      key += step[k];
    }
  }
  return key;
}

const JsonValue* descend(const JsonValue& value, std::string_view step) {
  if (const JsonValue::Array* array = value.array()) {
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(step.data(), step.data() + step.size(), index);
    const bool valid = error == std::errc() && end == step.data() + step.size() && index < array->size();
    return valid ? &(*array)[index] : nullptr;
  }
  return value.find(unescape(step));
}

}  // namespace

std::string escape_pointer_key(std::string_view key) {
  std::string step;
  for (const char c : key) {
    if (c == '~') {
      step += "~0";
    } else if (c == '/') {
      step += "~1";
    } else {
      step += c;
    }
  }
  return step;
}

std::string JsonPath::text() const {
  if (parent_ == nullptr) return std::string(key_);
  const std::string step = index_ == no_index ? escape_pointer_key(key_) : std::to_string(index_);
  return parent_->text() + "/" + step;
}

const JsonValue& resolve_pointer(const JsonValue& root, std::string_view pointer) {
  const JsonValue* value = &root;
  while (!pointer.empty()) {
    pointer.remove_prefix(1);
    const std::size_t end = std::min(pointer.find('/'), pointer.size());
    const JsonValue* next = descend(*value, pointer.substr(0, end));
    if (next == nullptr) break;
    value = next;
    pointer.remove_prefix(end);
  }
  return *value;
}

}  // namespace tps
