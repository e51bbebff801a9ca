#include "verify/vectors/question.hpp"

#include <nlohmann/json.hpp>

namespace tps::vectors {

JsonValue question_value(const Json& in) {
  JsonDocument document = parse_json(in.dump(), kQuestion);
  document.problems.throw_if_any();
  return std::move(document.root);
}

}  // namespace tps::vectors
