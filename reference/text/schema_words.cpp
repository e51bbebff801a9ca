#include "reference/text/schema_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "reference/text/json_pointer.hpp"
#include "reference/text/number_text.hpp"

namespace tps {
namespace {

/// What the `$ref` of a schema names; null without one.
const JsonValue* target_of(const JsonValue& root, const JsonValue& schema) {
  const JsonValue* reference = schema.find("$ref");
  return reference == nullptr ? nullptr : &resolve_pointer(root, reference->string()->substr(1));
}

std::string joined(const std::vector<std::string>& parts, std::string_view last_joint) {
  std::string text;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    if (k > 0) text += k + 1 == parts.size() ? last_joint : std::string_view(", ");
    text += parts[k];
  }
  return text;
}

std::string bound(const JsonValue& value) {
  return describe_found(value);
}

std::string describe_list(const SchemaView& schema) {
  const std::size_t least = schema.count("minItems", 0);
  const std::size_t most = schema.count("maxItems", 0);
  std::string text = "a list";
  if (most > 0 && least == most) text = fmt::format("a list of {} entries", most);
  if (most > 0 && least + 1 == most) text = fmt::format("a list of {} or {} entries", least, most);
  if (most > least + 1) text = fmt::format("a list of {} to {} entries", least, most);
  if (most == 0 && least > 0)
    text = fmt::format("a list of at least {} {}", least, least == 1 ? "entry" : "entries");
  if (const JsonValue* items = schema.find("items")) text += ", each " + describe_allowed(schema.at(*items));
  return text;
}

std::string describe_object(const SchemaView& schema) {
  std::vector<std::string> needed;
  for (const JsonValue& key : schema.list("required")) needed.push_back(*key.string());
  if (needed.empty()) return "an object";
  return fmt::format("an object with {} {}", needed.size() == 1 ? "the key" : "the keys",
                     quoted_list(needed, " and "));
}

std::string describe_type(const SchemaView& schema, std::string_view type) {
  const std::string range = describe_range(schema);
  const std::string tail = range.empty() ? "" : " " + range;
  if (type == "number") return "a number" + tail;
  if (type == "integer") return "an integer" + tail;
  if (type == "array") return describe_list(schema);
  if (type == "object") return describe_object(schema);
  if (type == "boolean") return "true or false";
  if (type == "null") return "null";
  const std::string_view format = schema.text("format");
  if (format == "tps-number") return "";  // another way to write the same number
  if (format == "tps-number-or-inf") return "\"inf\"";
  if (format == "tps-uint64") return "a string with a decimal or hexadecimal integer up to 2^64-1";
  const std::size_t least = schema.count("minLength", 0);
  const std::size_t most = schema.count("maxLength", 0);
  if (most > 0) return fmt::format("a string of at most {} characters", most);
  return least > 0 ? "a string that is not empty" : "a string";
}

std::string describe_keys(const JsonValue::Object& object) {
  constexpr std::size_t most_keys = 4;
  if (object.empty()) return "an empty object";
  if (object.size() > most_keys) return fmt::format("an object with {} keys", object.size());
  std::vector<std::string> keys;
  for (const JsonMember& member : object) keys.push_back(member.key);
  return fmt::format("an object with {} {}", keys.size() == 1 ? "the key" : "the keys",
                     quoted_list(keys, " and "));
}

// One part for each alternative.
std::vector<std::string> allowed_parts(const SchemaView& schema) {
  std::vector<std::string> parts;
  if (const JsonValue* constant = schema.find("const")) parts.push_back(describe_found(*constant));
  for (const JsonValue& value : schema.list("enum")) parts.push_back(describe_found(value));
  for (const JsonValue& alternative : schema.list("oneOf")) {
    for (const std::string& part : allowed_parts(schema.at(alternative))) parts.push_back(part);
  }
  if (!parts.empty()) return parts;
  for (const std::string_view type : schema.types()) {
    if (std::string part = describe_type(schema, type); !part.empty()) parts.push_back(std::move(part));
  }
  return parts;
}

}  // namespace

SchemaView::SchemaView(const JsonValue* root_in, const JsonValue* schema_in)
    : root(root_in), schema(schema_in), target(target_of(*root_in, *schema_in)) {}

const JsonValue* SchemaView::find(std::string_view keyword) const {
  if (const JsonValue* value = schema->find(keyword)) return value;
  for (const JsonValue* at = target; at != nullptr; at = target_of(*root, *at)) {
    if (const JsonValue* value = at->find(keyword)) return value;
  }
  return nullptr;
}

std::string_view SchemaView::text(std::string_view keyword) const {
  const JsonValue* value = find(keyword);
  return value == nullptr || value->string() == nullptr ? std::string_view() : *value->string();
}

std::size_t SchemaView::count(std::string_view keyword, std::size_t otherwise) const {
  const JsonValue* value = find(keyword);
  return value == nullptr ? otherwise : static_cast<std::size_t>(value->number()->value);
}

const JsonValue::Array& SchemaView::list(std::string_view keyword) const {
  static const JsonValue::Array none;
  const JsonValue* value = find(keyword);
  return value == nullptr || value->array() == nullptr ? none : *value->array();
}

std::vector<std::string_view> SchemaView::types() const {
  const JsonValue* type = find("type");
  if (type == nullptr) return {};
  if (type->string() != nullptr) return {*type->string()};
  std::vector<std::string_view> names;
  for (const JsonValue& name : *type->array()) names.push_back(*name.string());
  return names;
}

std::string describe_range(const SchemaView& schema) {
  const JsonValue* least = schema.find("minimum");
  const JsonValue* most = schema.find("maximum");
  const JsonValue* above = schema.find("exclusiveMinimum");
  const JsonValue* below = schema.find("exclusiveMaximum");
  if (least != nullptr && most != nullptr) return fmt::format("from {} to {}", bound(*least), bound(*most));
  std::vector<std::string> parts;
  if (above != nullptr) parts.push_back("greater than " + bound(*above));
  if (least != nullptr) parts.push_back("of at least " + bound(*least));
  if (below != nullptr) parts.push_back("less than " + bound(*below));
  if (most != nullptr) parts.push_back("of at most " + bound(*most));
  return joined(parts, " and ");
}

std::string describe_allowed(const SchemaView& schema) {
  return joined(allowed_parts(schema), " or ");
}

std::string describe_found(const JsonValue& value) {
  if (value.is_null()) return "null";
  if (const bool* boolean = value.boolean()) return *boolean ? "true" : "false";
  if (const JsonNumber* number = value.number()) return write_shortest(number->value);
  if (const std::string* string = value.string()) return in_quotes(*string);
  if (const JsonValue::Array* array = value.array()) {
    return fmt::format("a list of {} {}", array->size(), array->size() == 1 ? "entry" : "entries");
  }
  return describe_keys(*value.object());
}

std::string in_quotes(std::string_view text) {
  constexpr std::size_t longest = 60;
  std::string result = "\"";
  std::size_t characters = 0;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool begins_character = (byte & 0xC0U) != 0x80U;  // not a continuation byte of UTF-8
    if (begins_character && ++characters > longest) return result + "…\"";
    if (byte < 0x20 || byte == 0x7F) {
      result += fmt::format("\\u{:04x}", byte);
    } else {
      if (c == '"' || c == '\\') result += '\\';
      result += c;
    }
  }
  return result + "\"";
}

std::string quoted_list(const std::vector<std::string>& names, std::string_view last_joint) {
  std::vector<std::string> parts;
  for (const std::string& name : names) parts.push_back(in_quotes(name));
  return joined(parts, last_joint);
}

bool same_json(const JsonValue& a, const JsonValue& b) {
  if (a.data.index() != b.data.index()) return false;
  if (a.is_null()) return true;
  if (a.boolean() != nullptr) return *a.boolean() == *b.boolean();
  if (a.number() != nullptr) return a.number()->value == b.number()->value;
  if (a.string() != nullptr) return *a.string() == *b.string();
  if (a.array() != nullptr) {
    return std::equal(a.array()->begin(), a.array()->end(), b.array()->begin(), b.array()->end(), same_json);
  }
  return a.object()->size() == b.object()->size() &&
         std::all_of(a.object()->begin(), a.object()->end(), [&](const JsonMember& member) {
           const JsonValue* other = b.find(member.key);
           return other != nullptr && same_json(member.value, *other);
         });
}

}  // namespace tps
