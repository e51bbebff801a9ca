#include "properties/conform/siblings.hpp"

#include "reference/text/hexfloat.hpp"
#include "reference/text/number_text.hpp"

namespace tps::properties::conform {
namespace {

using Json = nlohmann::ordered_json;

double otherwise(double x) {
  return x == 0 ? 1. / 8 : 7. / 8 * x;
}

void change_each(const Json& whole, const Json::json_pointer& place, std::vector<Sibling>& found) {
  const Json& here = whole.at(place);
  if (here.is_structured()) {
    for (const auto& each : here.items()) {
      const bool in_list = here.is_array();
      change_each(whole, in_list ? place / std::stoul(each.key()) : place / each.key(), found);
    }
    return;
  }
  if (!here.is_string()) return;
  const HexFloat number = parse_hex_float(here.get_ref<const std::string&>());
  if (number.verdict != HexFloat::Verdict::exact || otherwise(number.value) == number.value) return;
  Json changed = whole;
  changed.at(place) = to_hex<double>(otherwise(number.value));
  found.push_back({place.to_string().substr(1), std::move(changed)});
}

}  // namespace

std::vector<Sibling> siblings_of(const Json& in) {
  std::vector<Sibling> found;
  change_each(in, Json::json_pointer(), found);
  return found;
}

}  // namespace tps::properties::conform
