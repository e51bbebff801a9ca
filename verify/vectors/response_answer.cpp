#include "verify/vectors/response_answer.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

#include "verify/certified/certified_response.hpp"
#include "verify/operations/compound_input.hpp"
#include "verify/vectors/enclosure_json.hpp"
#include "verify/vectors/next_event_answer.hpp"
#include "verify/vectors/question.hpp"
#include "verify/vectors/response_condition.hpp"

namespace tps::vectors {
namespace {

using certified::EnclosedVector;

Json answer_of(const certified::Response& response) {
  Json answer;
  if (!response.kind.empty()) answer["kind"] = response.kind;
  for (const auto& [key, components] : response.values) add_enclosures(answer, key, components);
  return answer;
}

Json one_response(const operations::Operation& operation, const Json& in) {
  const operations::Input input = operations::read_value(operation, question_value(in), {kQuestion, "/in"});
  const certified::Response response = certified::certified_response(operation.op, input);
  Json answer = answer_of(response);
  if (const auto other = certified::other_response(operation.op, input, response)) {
    answer["also"] = Json::array({answer_of(*other)});
  }
  answer["cond"] = conditions(operation.op, input, response);
  return answer;
}

/// All bodies' components in a row.
EnclosedVector flattened(const std::vector<EnclosedVector>& velocities) {
  EnclosedVector row;
  for (const EnclosedVector& v : velocities) row.insert(row.end(), v.begin(), v.end());
  return row;
}

Json group_answer(const Json& in) {
  const operations::GroupInput group = operations::read_group(question_value(in), {kQuestion, "/in"});
  const certified::GroupResponse response = certified::certified_group(group);
  if (response.boundary) throw std::invalid_argument("a collision of the group is at a boundary of rounding");
  Json answer;
  add_enclosures(answer, "loaded", flattened(response.loaded));
  add_enclosures(answer, "restituted", flattened(response.restituted));
  answer["cond"] = conditions(group, response);
  return answer;
}

}  // namespace

Json response_answer(Op op, const Json& in) {
  const operations::Operation& operation = operations::operation(op);
  switch (operation.answers) {
    case operations::Answers::response:
      return one_response(operation, in);
    case operations::Answers::group:
      return group_answer(in);
    case operations::Answers::event:
      if (std::optional<Json> answer = next_event_answer(in)) return *answer;
      throw std::invalid_argument("the scene has no event, or no single one");
    default:
      throw std::invalid_argument(fmt::format("{} has no known answers", operation.name));
  }
}

}  // namespace tps::vectors
