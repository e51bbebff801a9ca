#include "verify/protocol/compound.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "reference/text/file_kind.hpp"
#include "reference/text/hexfloat.hpp"
#include "reference/text/input_error.hpp"
#include "reference/text/json_document.hpp"
#include "reference/text/json_number.hpp"
#include "reference/text/text_file.hpp"
#include "verify/protocol/answer.hpp"

namespace tps::protocol {
namespace {

/// Calls use(in, place) on the input that a file holds.
template <typename Use>
auto with_input(std::string_view operation, const std::string& path, Use use) {
  refuse_other_kinds_of_file(path, "the input of an operation", {FileKind::requests});
  const JsonDocument document =
      parse_json_file(path, "the input of one operation is an object of that operation");
  document.problems.throw_if_any();
  const std::string source = display_name(path);
  const JsonValue* in = document.root.find("in");
  if (in == nullptr) return use(document.root, Place{source, ""});
  const JsonValue* op = document.root.find("op");
  if (op != nullptr && (op->string() == nullptr || *op->string() != operation)) {
    throw InputError(
        {{source, op->line, "/op", fmt::format("the request is for another operation than {}", operation)}});
  }
  return use(*in, Place{source, "/in"});
}

bool is_vector(const JsonValue::Array& list) {
  return !list.empty() &&
         std::all_of(list.begin(), list.end(), [](const JsonValue& x) { return json_number(x).has_value(); });
}

eval::Number spelled(const JsonValue& value) {
  const double x = *json_number(value);
  return {fmt::format("{}", x), to_hex(x)};
}

void flatten(const JsonValue& value, const std::string& name, eval::Report& report) {
  eval::Quantity quantity{name, name, "", {}, false, ""};
  if (const JsonValue::Object* object = value.object()) {
    for (const JsonMember& member : *object)
      flatten(member.value, name.empty() ? member.key : name + "." + member.key, report);
    return;
  }
  if (const JsonValue::Array* list = value.array(); list != nullptr && !is_vector(*list)) {
    for (std::size_t n = 0; n < list->size(); ++n)
      flatten((*list)[n], fmt::format("{}[{}]", name, n), report);
    return;
  }
  if (const JsonValue::Array* vector = value.array()) {
    for (const JsonValue& component : *vector) quantity.numbers.push_back(spelled(component));
    quantity.is_vector = true;
  } else if (value.number() != nullptr) {  // an id
    quantity.word = fmt::format("{}", value.number()->value);
  } else if (json_number(value)) {
    quantity.numbers.push_back(spelled(value));
  } else if (value.string() != nullptr) {
    quantity.word = *value.string();
  } else if (value.boolean() != nullptr) {
    quantity.word = *value.boolean() ? "true" : "false";
  }
  report.results.push_back(quantity);
}

}  // namespace

const std::vector<Compound>& compounds() {
  static const std::vector<Compound> table{
      {"order", "which of two events comes first",
       R"({"first":{"kind":"block"|"tether",u_A,u_B,v_A,v_B,L},"second":…})", "certified", "order",
       "docs/exact.md"},
      {"group", "velocities of bodies grouped by collisions, eqs. (3)-(7)",
       R"({"bodies":[{m,u,v},…],"collisions":[{i,j,"limit":"inner",c},…]})", "certified", "grouping",
       "docs/protocol.md"},
      {"next_event", "the next event of a scene and the state after it", R"({"scene":…})", "certified",
       "engine", "docs/protocol.md"},
      {"simulate", "the trace of a scene's run", R"({"scene":…,"max_events":…})", "double, certified timing",
       "whole runs", "docs/check.md"},
  };
  return table;
}

const Compound* find_compound(std::string_view name) {
  const auto& table = compounds();
  const auto found =
      std::find_if(table.begin(), table.end(), [&](const Compound& c) { return c.name == name; });
  return found == table.end() ? nullptr : &*found;
}

std::string answer_file(const Compound& operation, const std::string& path) {
  return with_input(operation.name, path, [&](const JsonValue& in, const Place& place) {
    return answer(operation.name, in, place.source, place.pointer);
  });
}

OrderInput read_order_file(const std::string& path) {
  return with_input("order", path,
                    [](const JsonValue& in, const Place& place) { return read_order(in, place); });
}

eval::Report report_of(const std::string& out) {
  eval::Report report;
  flatten(parse_json(out, "result").root, "", report);
  return report;
}

}  // namespace tps::protocol
