// A JSON Schema as the judge of a document, with messages for people.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "reference/text/input_error.hpp"
#include "reference/text/json_document.hpp"

namespace tps {

/// A schema in the part of JSON Schema 2020-12 that our file formats use:
///
/// - `$ref` to "#/$defs/NAME"; keywords beside it are added to those of the target, never repeated;
/// - `type`, `const`, `enum`, `minimum`, `maximum`, `exclusiveMinimum`, `exclusiveMaximum`;
/// - `required`, `properties`, `additionalProperties`, `minProperties`; `items`, `minItems`, `maxItems`;
///   `minLength`, `maxLength`;
/// - `oneOf` for alternatives that the type or a required key tells apart;
/// - `anyOf` for "at least one of these keys": alternatives of `required` alone;
/// - `not: {}` for a key that is known and refused; its `description` is the message;
/// - `format` for strings that hold numbers: "tps-number" (a hexadecimal float), "tps-number-or-inf" and
///   "tps-uint64" (an integer). Beside it `minimum` and its kin hold for the string's number too, which a
///   standard validator cannot see: it judges the string by `pattern`, which is not interpreted here.
///
/// `title`, `description`, `default` and `examples` are for people.
class Schema {
 public:
  /// REQUIRES a schema within the part above: anything else throws std::logic_error that names the place.
  Schema(std::string_view text, const std::string& name);
  Schema(JsonDocument document, const std::string& name);

  /// Adds everything that is wrong with `value` to `problems`; `prefix` is the JSON pointer of `value` in its
  /// file. A value of the wrong type is reported once, not looked into.
  void validate(const JsonValue& value, InputProblems& problems, std::string_view prefix = "") const;

 private:
  JsonDocument document_;
};

/// The schema `data/schemas/NAME.schema.json`, which is part of the program. REQUIRES that there is one.
const Schema& embedded_schema(std::string_view name);

/// The text of that file.
std::string_view embedded_schema_text(std::string_view name);

/// Names of all embedded schemas.
std::vector<std::string_view> embedded_schema_names();

}  // namespace tps
