#include "reference/text/plain_json.hpp"

#include <nlohmann/json.hpp>

#include "reference/text/printable.hpp"

namespace tps {
namespace {

using json = nlohmann::ordered_json;

json number_of(const JsonNumber& number) {
  switch (number.integer) {
    case JsonNumber::Integer::natural:
      return number.magnitude;
    case JsonNumber::Integer::negative:
      return static_cast<std::int64_t>(0 - number.magnitude);
    case JsonNumber::Integer::none:
      break;
  }
  return number.value;
}

/// As deep as the reader's limit, which is small.
json plain(const JsonValue& value) {
  if (const bool* b = value.boolean()) return *b;
  if (const JsonNumber* number = value.number()) return number_of(*number);
  if (const std::string* text = value.string()) return *text;
  if (const JsonValue::Array* array = value.array()) {
    json list = json::array();
    for (const JsonValue& entry : *array) list.push_back(plain(entry));
    return list;
  }
  if (const JsonValue::Object* object = value.object()) {
    json::object_t members;  // keys differ, so that none is looked up: that would be quadratic
    for (const JsonMember& member : *object) members.emplace_back(member.key, plain(member.value));
    return members;
  }
  return nullptr;
}

}  // namespace

json parse_plain_json(std::string_view text, const std::string& name, const JsonLimits& limits,
                      std::size_t first_line) {
  const JsonDocument document = parse_json(text, name, limits, first_line);
  document.problems.throw_if_any();
  return plain(document.root);
}

std::string json_text(const json& value, int indent) {
  // The library escapes below U+0020 only. Whatever else must not be printed is above U+007E and stands
  // inside strings; all but letters and signs of other languages are escaped.
  return escape_in_json(value.dump(indent, ' ', false, json::error_handler_t::replace));
}

std::string shown(const json& value) {
  constexpr std::size_t kMost = 120;
  const std::string text = value.dump(-1, ' ', false, json::error_handler_t::replace);
  return printable(text, kMost);
}

std::string first_problem(const InputError& error) {
  const InputProblem& problem = error.problems().front();
  return problem.pointer.empty() ? problem.message : problem.pointer + ": " + problem.message;
}

}  // namespace tps
