#include "reference/scene/scene_key.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <variant>

#include "reference/text/schema_words.hpp"

namespace tps {
namespace {

// What data/schemas/ has, and the keys that effects bring along.
JsonDocument whole_scene_schema() {
  JsonDocument schema = parse_json(embedded_schema_text("scene"), "scene.schema.json");
  JsonValue::Object& root = std::get<JsonValue::Object>(schema.root.data);
  const auto properties = std::find_if(root.begin(), root.end(),
                                       [](const JsonMember& member) { return member.key == "properties"; });
  JsonValue::Object& keys = std::get<JsonValue::Object>(properties->value.data);
  for (const SceneKey& key : scene_keys()) {
    const std::string name(key.key);
    JsonValue own = parse_json(key.schema, "the schema of \"" + name + "\"").root;
    const JsonValue* known = properties->value.find(name);
    if (known == nullptr) {
      keys.push_back({name, 0, std::move(own)});
    } else if (!same_json(own, *known)) {
      throw std::logic_error(
          "the key \"" + name +
          "\" of an effect has another schema than in scene.schema.json, or in another effect");
    }
  }
  return schema;
}

}  // namespace

const Schema& scene_schema() {
  static const Schema schema(whole_scene_schema(), "scene.schema.json");
  return schema;
}

void read_keys_of_effects(Scene& scene, SceneSource& source) {
  for (const SceneKey& key : scene_keys()) {
    const JsonValue* value = source.root().find(key.key);
    if (value == nullptr || !source.sound({key.key})) continue;
    scene.sections.emplace(key.key, SharedSection(key.read(*value, scene, source)));
  }
}

}  // namespace tps
