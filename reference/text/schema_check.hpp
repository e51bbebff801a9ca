// Whether a schema keeps to the part of JSON Schema that is interpreted here.
#pragma once

#include <string>

#include "reference/text/json_document.hpp"

namespace tps {

/// Throws std::logic_error that names the first place of the schema that the interpreter would not
/// understand: a keyword it ignores would let wrong files pass.
void require_supported_schema(const JsonValue& root, const std::string& name);

}  // namespace tps
