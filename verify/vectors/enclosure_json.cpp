#include "verify/vectors/enclosure_json.hpp"

#include <nlohmann/json.hpp>

namespace tps::vectors {
namespace {

const char* nearest_name(const certified::Enclosure& e) {
  return e.nearest == e.lo ? "lo" : e.nearest == e.hi ? "hi" : "mid";
}

}  // namespace

void add_enclosures(Json& answer, const std::string& key, const certified::EnclosedVector& components) {
  Json enclosures = Json::array();
  Json nearest = Json::array();
  for (const certified::Enclosure& e : components) {
    enclosures.push_back({hex(e.lo), hex(e.hi)});
    nearest.push_back(nearest_name(e));
  }
  answer["out"][key] = enclosures;
  answer["nearest"][key] = nearest;
}

}  // namespace tps::vectors
