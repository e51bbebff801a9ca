// A schema and a value in words, for messages.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "reference/text/json_document.hpp"

namespace tps {

/// A schema as its readers see it: a keyword is looked up in the schema, then in the target of its `$ref`.
struct SchemaView {
  /// `root_in` is the whole schema file, `schema_in` the schema at hand.
  SchemaView(const JsonValue* root_in, const JsonValue* schema_in);

  const JsonValue* root;
  const JsonValue* schema;
  const JsonValue* target;  ///< of its `$ref`; null without one

  /// The value of a keyword; null if absent.
  const JsonValue* find(std::string_view keyword) const;
  SchemaView at(const JsonValue& subschema) const { return {root, &subschema}; }

  /// The text of a keyword, empty if absent.
  std::string_view text(std::string_view keyword) const;
  /// The number of a keyword as a count, or `otherwise`.
  std::size_t count(std::string_view keyword, std::size_t otherwise) const;
  /// The entries of a list keyword; none if absent.
  const JsonValue::Array& list(std::string_view keyword) const;
  /// Names of the types allowed; none: all.
  std::vector<std::string_view> types() const;
};

/// What the schema allows: "a number from 0 to 1", "a list of 2 or 3 entries, each a number".
std::string describe_allowed(const SchemaView& schema);

/// "greater than 0", "from 0 to 1", "at least 0"; empty without bounds.
std::string describe_range(const SchemaView& schema);

/// What stands in the file: `1.5`, `"abc"`, `a list of 3 entries`; long text is cut.
std::string describe_found(const JsonValue& value);

/// `"a", "b" or "c"`, each name quoted.
std::string quoted_list(const std::vector<std::string>& names, std::string_view last_joint);

/// A text in quotes as JSON would write it, cut after 60 characters.
std::string in_quotes(std::string_view text);

/// Same value of the same type.
bool same_json(const JsonValue& a, const JsonValue& b);

}  // namespace tps
