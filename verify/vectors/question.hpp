// The "in" of a known answer, for the readers of the protocol.
#pragma once

#include <string>

#include "reference/text/json_document.hpp"
#include "verify/vectors/known_answer.hpp"

namespace tps::vectors {

/// What messages call the document.
inline const std::string kQuestion = "case";

/// The same value as the strict reader of documents gives it. Throws InputError.
JsonValue question_value(const Json& in);

}  // namespace tps::vectors
