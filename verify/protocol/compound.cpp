#include "verify/protocol/compound.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "reference/text/file_kind.hpp"
#include "reference/text/hexfloat.hpp"
#include "reference/text/input_error.hpp"
#include "reference/text/json_document.hpp"
#include "reference/text/plain_json.hpp"
#include "reference/text/text_file.hpp"
#include "reference/text/typed_number.hpp"
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

using Json = nlohmann::ordered_json;

/// Numbers of answers are strings; ids are numbers of JSON.
std::optional<double> number_of(const Json& value) {
  return value.is_string() ? typed_number(value.get_ref<const std::string&>()).value : std::nullopt;
}

bool is_vector(const Json& list) {
  return !list.empty() &&
         std::all_of(list.begin(), list.end(), [](const Json& x) { return number_of(x).has_value(); });
}

eval::Number spelled(double x) {
  return {fmt::format("{}", x), to_hex(x)};
}

void flatten(const Json& value, const std::string& name, eval::Report& report) {
  if (value.is_object()) {
    for (const auto& [key, member] : value.items())
      flatten(member, name.empty() ? key : name + "." + key, report);
    return;
  }
  if (value.is_array() && !is_vector(value)) {
    for (std::size_t n = 0; n < value.size(); ++n) flatten(value[n], fmt::format("{}[{}]", name, n), report);
    return;
  }
  eval::Quantity quantity{name, name, "", {}, value.is_array(), ""};
  if (value.is_array()) {
    for (const Json& component : value) quantity.numbers.push_back(spelled(*number_of(component)));
  } else if (const std::optional<double> number = number_of(value)) {
    quantity.numbers.push_back(spelled(*number));
  } else if (value.is_string()) {
    quantity.word = value.get<std::string>();
  } else if (!value.is_null()) {  // an id, a flag
    quantity.word = json_text(value);
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
    return answer_text(operation.name, in, place.source, place.pointer);
  });
}

eval::Report report_file(const Compound& operation, const std::string& path) {
  return with_input(operation.name, path, [&](const JsonValue& in, const Place& place) {
    return report_of(operation.name == kSimulate
                         ? parse_plain_json(answer_text(kSimulate, in, place.source, place.pointer), "trace")
                         : answer(operation.name, in, place.source, place.pointer));
  });
}

OrderInput read_order_file(const std::string& path) {
  return with_input("order", path,
                    [](const JsonValue& in, const Place& place) { return read_order(in, place); });
}

eval::Report report_of(const Json& out) {
  eval::Report report;
  flatten(out, "", report);
  return report;
}

}  // namespace tps::protocol
