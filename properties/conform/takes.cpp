#include "properties/conform/takes.hpp"

#include <algorithm>

namespace tps::properties::conform {
namespace {

/// The first list of numbers, which has as many as the question has dimensions; 0 where there is none.
std::size_t dimension_of(const Json& value) {
  if (value.is_object() && value.contains("dimension")) return value.at("dimension").get<std::size_t>();
  if (!value.is_structured()) return 0;
  if (value.is_array() && !value.empty() && !value.front().is_structured()) return value.size();
  for (const Json& each : value) {
    if (const std::size_t found = dimension_of(each); found > 0) return found;
  }
  return 0;
}

bool has_infinite_mass(const Json& value) {
  if (value.is_structured()) return std::any_of(value.begin(), value.end(), has_infinite_mass);
  return value == "inf";  // nothing but a mass may be
}

bool has_tethers(const Json& in) {
  const auto scene = in.find("scene");
  if (scene == in.end()) return false;
  if (!scene->value("tethers", Json::array()).empty()) return true;
  const Json laws = scene->value("pairs", Json::array());
  return std::any_of(laws.begin(), laws.end(), [](const Json& law) { return law.contains("tethering"); });
}

}  // namespace

bool takes(const std::vector<std::string>& features, const Question& question) {
  return std::all_of(features.begin(), features.end(), [&](const std::string& feature) {
    if (feature == "2d") return dimension_of(question.in) != 3;
    if (feature == "3d") return dimension_of(question.in) != 2;
    if (feature == "no-infinite-masses") return !has_infinite_mass(question.in);
    return feature != "no-tethers" || !has_tethers(question.in);
  });
}

}  // namespace tps::properties::conform
