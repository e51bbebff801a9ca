#include "reference/text/fields.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "reference/text/json_pointer.hpp"
#include "reference/text/nearest_name.hpp"
#include "reference/text/schema_words.hpp"

namespace tps {

void Field::require_keys(std::initializer_list<std::string_view> needed,
                         std::initializer_list<std::string_view> optional) const {
  const JsonValue::Object* object = value_->object();
  if (object == nullptr) refuse(fmt::format("is {}; an object stands here", describe_found(*value_)));
  const auto in = [](std::initializer_list<std::string_view> list, std::string_view key) {
    return std::find(list.begin(), list.end(), key) != list.end();
  };
  for (const JsonMember& member : *object) {
    if (in(needed, member.key) || in(optional, member.key)) continue;
    std::vector<std::string> known(needed.begin(), needed.end());
    known.insert(known.end(), optional.begin(), optional.end());
    inside(member.value, member.key).refuse("is not known here" + did_you_mean(member.key, known));
  }
  for (const std::string_view key : needed) {
    if (!has(key)) refuse(fmt::format("lacks the key \"{}\"", key));
  }
}

Field Field::at(std::string_view key) const {
  return inside(*value_->find(key), key);
}

std::vector<Field> Field::list() const {
  const JsonValue::Array* array = value_->array();
  if (array == nullptr) refuse(fmt::format("is {}; a list stands here", describe_found(*value_)));
  std::vector<Field> entries;
  entries.reserve(array->size());
  for (std::size_t n = 0; n < array->size(); ++n) entries.push_back(inside((*array)[n], std::to_string(n)));
  return entries;
}

std::vector<Field> Field::list_of(std::size_t size) const {
  const JsonValue::Array* array = value_->array();
  if (array == nullptr || array->size() != size)
    refuse(fmt::format("is {}; a list of {} entries stands here", describe_found(*value_), size));
  return list();
}

std::vector<std::pair<std::string, Field>> Field::members() const {
  const JsonValue::Object* object = value_->object();
  if (object == nullptr) refuse(fmt::format("is {}; an object stands here", describe_found(*value_)));
  std::vector<std::pair<std::string, Field>> all;
  for (const JsonMember& member : *object) all.emplace_back(member.key, inside(member.value, member.key));
  return all;
}

const std::string& Field::text() const {
  if (value_->string() == nullptr)
    refuse(fmt::format("is {}; a string stands here", describe_found(*value_)));
  return *value_->string();
}

bool Field::truth() const {
  if (value_->boolean() == nullptr)
    refuse(fmt::format("is {}; true or false stands here", describe_found(*value_)));
  return *value_->boolean();
}

std::uint64_t Field::natural(std::uint64_t most) const {
  const JsonNumber* number = value_->number();
  if (number == nullptr || number->integer != JsonNumber::Integer::natural || number->magnitude > most) {
    refuse(fmt::format("is {}; an integer from 0 to {} stands here", describe_found(*value_), most));
  }
  return number->magnitude;
}

std::size_t Field::word(std::initializer_list<std::string_view> allowed) const {
  const std::string* text = value_->string();
  const auto* found = text == nullptr ? allowed.end() : std::find(allowed.begin(), allowed.end(), *text);
  if (found == allowed.end()) {
    refuse(fmt::format("is {}; allowed are \"{}\"", describe_found(*value_), fmt::join(allowed, "\", \"")));
  }
  return static_cast<std::size_t>(found - allowed.begin());
}

void Field::refuse(std::string message) const {
  throw InputError({{*file_, value_->line, pointer_, std::move(message)}});
}

Field Field::inside(const JsonValue& value, std::string_view step) const {
  Field field(value, *file_);
  field.pointer_ = pointer_ + "/" + escape_pointer_key(step);
  return field;
}

}  // namespace tps
