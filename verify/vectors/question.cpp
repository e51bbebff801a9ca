#include "verify/vectors/question.hpp"

#include <nlohmann/json.hpp>

#include "reference/text/plain_json.hpp"

namespace tps::vectors {

JsonValue question_value(const Json& in) {
  JsonDocument document = parse_json(json_text(in), kQuestion);
  document.problems.throw_if_any();
  return std::move(document.root);
}

}  // namespace tps::vectors
