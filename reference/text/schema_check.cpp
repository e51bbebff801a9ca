#include "reference/text/schema_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string_view>

#include "reference/text/json_pointer.hpp"

namespace tps {
namespace {

// Keywords that say something to people only.
constexpr std::array<std::string_view, 7> annotations = {"$schema",     "$id",     "$defs",   "title",
                                                         "description", "default", "examples"};
// Keywords whose value is no schema.
constexpr std::array<std::string_view, 15> assertions = {
    "type",     "const",         "enum",     "minimum",  "maximum",   "exclusiveMinimum", "exclusiveMaximum",
    "required", "minProperties", "minItems", "maxItems", "minLength", "maxLength",        "format",
    "pattern"};
constexpr std::array<std::string_view, 3> formats = {"tps-number", "tps-number-or-inf", "tps-uint64"};

template <typename List>
bool among(const List& list, std::string_view name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

class Check {
 public:
  Check(const JsonValue& root, const std::string& name) : root_(root), name_(name) {}

  void schema(const JsonValue& value, const JsonPath& path) {
    if (value.object() == nullptr) fail(path, "a schema must be an object");
    for (const JsonMember& member : *value.object()) {
      const JsonPath place = path.key(member.key);
      keyword(value, member, place);
    }
  }

 private:
  [[noreturn]] void fail(const JsonPath& path, std::string_view message) const {
    throw std::logic_error(fmt::format("{}: {}: {}", name_, path.text(), message));
  }

  void keyword(const JsonValue& schema, const JsonMember& member, const JsonPath& place) {
    const std::string& key = member.key;
    if (key == "$defs" || key == "properties") {
      for (const JsonMember& sub : *member.value.object()) {
        const JsonPath sub_place = place.key(sub.key);
        this->schema(sub.value, sub_place);
      }
    } else if (key == "items") {
      this->schema(member.value, place);
    } else if (key == "additionalProperties") {
      if (member.value.boolean() == nullptr) this->schema(member.value, place);
    } else if (key == "oneOf") {
      for (std::size_t k = 0; k < member.value.array()->size(); ++k) {
        const JsonPath sub_place = place.item(k);
        this->schema((*member.value.array())[k], sub_place);
      }
    } else if (key == "anyOf") {
      for (const JsonValue& alternative : *member.value.array()) {
        if (alternative.object()->size() != 1 || alternative.find("required") == nullptr) {
          fail(place, "alternatives of anyOf may only say which keys are required");
        }
      }
    } else if (key == "not") {
      if (!member.value.object()->empty() || schema.find("description") == nullptr) {
        fail(place, "allowed: an empty schema, with a description that is the message");
      }
    } else if (key == "$ref") {
      reference(schema, member, place);
    } else if (key == "pattern") {
      if (schema.find("format") == nullptr) fail(place, "pattern needs a format that is interpreted");
    } else if (key == "format") {
      if (!among(formats, *member.value.string())) fail(place, "unknown format");
    } else if (!among(annotations, key) && !among(assertions, key)) {
      fail(place, "this keyword is not interpreted");
    }
  }

  void reference(const JsonValue& schema, const JsonMember& member, const JsonPath& place) {
    const std::string& target = *member.value.string();
    const JsonValue* defs = root_.find("$defs");
    const JsonValue* found = nullptr;
    if (target.starts_with("#/$defs/") && defs != nullptr) found = defs->find(target.substr(8));
    if (found == nullptr) fail(place, "allowed: \"#/$defs/NAME\" of a definition that exists");
    for (const JsonMember& sibling : *schema.object()) {
      if (sibling.key != "$ref" && !among(annotations, sibling.key) && found->find(sibling.key) != nullptr) {
        fail(place, "a keyword beside $ref repeats one of its target");
      }
    }
  }

  const JsonValue& root_;
  const std::string& name_;
};

}  // namespace

void require_supported_schema(const JsonValue& root, const std::string& name) {
  Check(root, name).schema(root, JsonPath());
}

}  // namespace tps
