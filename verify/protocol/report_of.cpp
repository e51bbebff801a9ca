#include "verify/protocol/report_of.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "reference/text/hexfloat.hpp"
#include "reference/text/plain_json.hpp"
#include "reference/text/typed_number.hpp"

namespace tps::protocol {
namespace {

using Json = nlohmann::ordered_json;

/// Numbers of answers are strings; ids are numbers of JSON.
std::optional<double> number_of(const Json& value) {
  return value.is_string() ? typed_number(value.get_ref<const std::string&>()).value : std::nullopt;
}

bool is_vector(const Json& list) {
  return !list.empty() &&
         std::all_of(list.begin(), list.end(), [](const Json& x) { return number_of(x).has_value(); });
}

operations::Number spelled(double x) {
  return {fmt::format("{}", x), to_hex(x)};
}

void flatten(const Json& value, const std::string& name, operations::Report& report) {
  if (value.is_object()) {
    for (const auto& [key, member] : value.items())
      flatten(member, name.empty() ? key : name + "." + key, report);
    return;
  }
  if (value.is_array() && !is_vector(value)) {
    for (std::size_t n = 0; n < value.size(); ++n) flatten(value[n], fmt::format("{}[{}]", name, n), report);
    return;
  }
  operations::Quantity quantity{name, name, "", {}, value.is_array(), ""};
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

operations::Report report_of(const Json& out) {
  operations::Report report;
  flatten(out, "", report);
  return report;
}

}  // namespace tps::protocol
