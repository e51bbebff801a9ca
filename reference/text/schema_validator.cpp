#include "reference/text/schema_validator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <stdexcept>

#include "reference/text/json_number.hpp"
#include "reference/text/json_pointer.hpp"
#include "reference/text/nearest_name.hpp"
#include "reference/text/number_text.hpp"
#include "reference/text/schema_check.hpp"
#include "reference/text/schema_words.hpp"

namespace tps {
namespace {

bool holds_number(std::string_view format) {
  return format == "tps-number" || format == "tps-number-or-inf";
}

bool has_type(const JsonValue& value, std::string_view type) {
  if (type == "null") return value.is_null();
  if (type == "boolean") return value.boolean() != nullptr;
  if (type == "string") return value.string() != nullptr;
  if (type == "array") return value.array() != nullptr;
  if (type == "object") return value.object() != nullptr;
  if (value.number() == nullptr) return false;
  return type == "number" || std::trunc(value.number()->value) == value.number()->value;
}

bool has_allowed_type(const JsonValue& value, const SchemaView& schema) {
  const std::vector<std::string_view> types = schema.types();
  return types.empty() || std::any_of(types.begin(), types.end(),
                                      [&](std::string_view type) { return has_type(value, type); });
}

bool in_range(double value, const SchemaView& schema) {
  const auto bound = [&](std::string_view keyword) -> std::optional<double> {
    const JsonValue* limit = schema.find(keyword);
    if (limit == nullptr) return std::nullopt;
    return limit->number()->value;
  };
  const std::optional<double> least = bound("minimum");
  const std::optional<double> most = bound("maximum");
  const std::optional<double> above = bound("exclusiveMinimum");
  const std::optional<double> below = bound("exclusiveMaximum");
  return (!least || value >= *least) && (!most || value <= *most) && (!above || value > *above) &&
         (!below || value < *below);
}

std::size_t characters(std::string_view utf8) {
  return static_cast<std::size_t>(std::count_if(
      utf8.begin(), utf8.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

// Walks a document and its schema side by side.
class Validation {
 public:
  explicit Validation(InputProblems& problems) : problems_(problems) {}

  void value(const JsonValue& value, const SchemaView& schema, const JsonPath& path) {
    if (schema.find("not") != nullptr) {
      add(value.line, path, std::string(schema.text("description")));
    } else if (schema.find("oneOf") != nullptr) {
      alternatives(value, schema, path);
    } else if (!has_allowed_type(value, schema) || !is_listed(value, schema)) {
      mismatch(value, schema, path);
    } else if (const JsonNumber* number = value.number()) {
      number_value(value, *number, schema, path);
    } else if (const std::string* string = value.string()) {
      string_value(value, *string, schema, path);
    } else if (const JsonValue::Array* array = value.array()) {
      array_value(value, *array, schema, path);
    } else if (const JsonValue::Object* object = value.object()) {
      object_value(value, *object, schema, path);
    }
  }

 private:
  void add(std::size_t line, const JsonPath& path, std::string message) {
    problems_.add(line, path.text(), std::move(message));
  }

  void mismatch(const JsonValue& value, const SchemaView& schema, const JsonPath& path) {
    std::string message =
        fmt::format("found {}; allowed: {}", describe_found(value), describe_allowed(schema));
    if (value.string() != nullptr && holds_number(schema.text("format"))) {
      message += "; a number in a string is a hexadecimal float like \"0x1.8p+1\"";
    }
    add(value.line, path, std::move(message));
  }

  static bool is_listed(const JsonValue& value, const SchemaView& schema) {
    if (const JsonValue* constant = schema.find("const")) return same_json(value, *constant);
    const JsonValue::Array& allowed = schema.list("enum");
    return allowed.empty() || std::any_of(allowed.begin(), allowed.end(),
                                          [&](const JsonValue& entry) { return same_json(value, entry); });
  }

  void number_value(const JsonValue& value, const JsonNumber& number, const SchemaView& schema,
                    const JsonPath& path) {
    if (!in_range(number.value, schema)) {
      mismatch(value, schema, path);
    } else if (number.rounded_integer && schema.text("format") == "tps-uint64") {
      add(value.line, path,
          fmt::format(
              "this integer is not exact as a number (the nearest double is {}); write it as a string",
              describe_found(value)));
    }
  }

  void string_value(const JsonValue& value, const std::string& string, const SchemaView& schema,
                    const JsonPath& path) {
    const std::string_view format = schema.text("format");
    if (holds_number(format)) {
      const bool infinite = string == "inf" && format == "tps-number-or-inf";
      const HexFloat hex = parse_hex_float(string);
      if (!infinite && hex.verdict == HexFloat::Verdict::not_a_double) {
        add(value.line, path,
            fmt::format("found {}, which no double holds exactly; allowed: a hexadecimal float of at most 53 "
                        "significant bits within the range of a double",
                        describe_found(value)));
      } else if (!infinite && (hex.verdict == HexFloat::Verdict::malformed || !in_range(hex.value, schema))) {
        mismatch(value, schema, path);
      }
    } else if (format == "tps-uint64") {
      if (!json_uint64(value)) mismatch(value, schema, path);
    } else if (const std::size_t length = characters(string);
               length < schema.count("minLength", 0) || length > schema.count("maxLength", length)) {
      mismatch(value, schema, path);
    }
  }

  void array_value(const JsonValue& value, const JsonValue::Array& array, const SchemaView& schema,
                   const JsonPath& path) {
    if (array.size() < schema.count("minItems", 0) || array.size() > schema.count("maxItems", array.size())) {
      mismatch(value, schema, path);
      return;
    }
    const JsonValue* items = schema.find("items");
    if (items == nullptr) return;
    for (std::size_t k = 0; k < array.size() && !problems_.full(); ++k) {
      const JsonPath entry = path.item(k);
      this->value(array[k], schema.at(*items), entry);
    }
  }

  void object_value(const JsonValue& value, const JsonValue::Object& object, const SchemaView& schema,
                    const JsonPath& path) {
    required_keys(value, schema, path);
    if (object.size() < schema.count("minProperties", 0)) {
      add(value.line, path, fmt::format("is empty; at least {} needed", schema.count("minProperties", 0)));
    }
    const JsonValue* properties = schema.find("properties");
    const JsonValue* others = schema.find("additionalProperties");
    for (const JsonMember& member : object) {
      if (problems_.full()) return;
      const JsonPath place = path.key(member.key);
      const JsonValue* property = properties == nullptr ? nullptr : properties->find(member.key);
      if (property != nullptr) {
        this->value(member.value, schema.at(*property), place);
      } else if (others != nullptr && others->boolean() == nullptr) {
        this->value(member.value, schema.at(*others), place);
      } else if (others != nullptr && !*others->boolean()) {
        unknown_key(member, schema, path);
      }
    }
  }

  void required_keys(const JsonValue& value, const SchemaView& schema, const JsonPath& path) {
    const JsonValue* properties = schema.find("properties");
    for (const JsonValue& entry : schema.list("required")) {
      const std::string& key = *entry.string();
      if (value.find(key) != nullptr) continue;
      const JsonValue* property = properties == nullptr ? nullptr : properties->find(key);
      const std::string allowed = property == nullptr ? "" : describe_allowed(schema.at(*property));
      add(value.line, path,
          fmt::format("key {} is missing{}", in_quotes(key), allowed.empty() ? "" : "; it holds " + allowed));
    }
    std::vector<std::string> one_of;
    for (const JsonValue& alternative : schema.list("anyOf")) {
      for (const JsonValue& key : schema.at(alternative).list("required")) one_of.push_back(*key.string());
    }
    const auto present = [&](const std::string& key) { return value.find(key) != nullptr; };
    if (!one_of.empty() && std::none_of(one_of.begin(), one_of.end(), present)) {
      add(value.line, path,
          fmt::format("at least one of the keys {} is needed", quoted_list(one_of, " and ")));
    }
  }

  void unknown_key(const JsonMember& member, const SchemaView& schema, const JsonPath& path) {
    std::vector<std::string> known;
    if (const JsonValue* properties = schema.find("properties")) {
      for (const JsonMember& property : *properties->object()) {
        if (schema.at(property.value).find("not") == nullptr) known.push_back(property.key);
      }
    }
    if (known.empty()) {
      add(member.key_line, path,
          fmt::format("unknown key {}; no key is allowed here", in_quotes(member.key)));
      return;
    }
    add(member.key_line, path,
        fmt::format("unknown key {}; the nearest known key is {}; allowed: {}", in_quotes(member.key),
                    in_quotes(nearest_name(member.key, known)), quoted_list(known, ", ")));
  }

  // The alternative that was meant is the one whose type fits and, among objects, the one of whose required
  // keys the value has any. Its errors are then the readable ones.
  void alternatives(const JsonValue& value, const SchemaView& schema, const JsonPath& path) {
    const JsonValue* meant = nullptr;
    std::size_t fitting = 0;
    for (const JsonValue& entry : schema.list("oneOf")) {
      const SchemaView alternative = schema.at(entry);
      if (!has_allowed_type(value, alternative) || !is_listed(value, alternative)) continue;
      const JsonValue::Array& keys = alternative.list("required");
      const bool has_key = std::any_of(keys.begin(), keys.end(), [&](const JsonValue& key) {
        return value.find(*key.string()) != nullptr;
      });
      if (!keys.empty() && !has_key) continue;
      meant = &entry;
      ++fitting;
    }
    if (fitting == 1) {
      this->value(value, schema.at(*meant), path);
    } else {
      mismatch(value, schema, path);
    }
  }

  InputProblems& problems_;
};

}  // namespace

Schema::Schema(std::string_view text, const std::string& name) : Schema(parse_json(text, name), name) {}

Schema::Schema(JsonDocument document, const std::string& name) : document_(std::move(document)) {
  require_supported_schema(document_.root, name);
}

void Schema::validate(const JsonValue& value, InputProblems& problems, std::string_view prefix) const {
  Validation(problems).value(value, SchemaView(&document_.root, &document_.root), JsonPath(prefix));
}

const Schema& embedded_schema(std::string_view name) {
  static const std::map<std::string, Schema, std::less<>> schemas = [] {
    std::map<std::string, Schema, std::less<>> all;
    for (const std::string_view each : embedded_schema_names()) {
      const std::string file = std::string(each) + ".schema.json";
      all.emplace(std::string(each), Schema(embedded_schema_text(each), file));
    }
    return all;
  }();
  const auto found = schemas.find(name);
  if (found == schemas.end()) throw std::logic_error(fmt::format("no schema named {}", name));
  return found->second;
}

}  // namespace tps
