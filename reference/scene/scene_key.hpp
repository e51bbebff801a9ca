// A key of a scene that an effect brings along: its schema, how it is read, checked and written.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "reference/scene/scene.hpp"
#include "reference/scene/scene_source.hpp"
#include "reference/text/schema_validator.hpp"

namespace tps {

struct SceneKey {
  std::string_view key;     ///< of the scene's top level
  std::string_view schema;  ///< of its value; may refer to the "$defs" of data/schemas/scene.schema.json

  /// Reads a value that the schema accepts, and reports what else is wrong with it to the source, at
  /// "/KEY/…". Species and particles of the scene are there, and whole.
  std::shared_ptr<const SceneSection> (*read)(const JsonValue& value, const Scene& scene,
                                              SceneSource& source);
};

/// Of all effects there are. Told by their catalogue, reference/engine/effect_facts.cpp.
const std::vector<SceneKey>& scene_keys();

/// data/schemas/scene.schema.json with these keys. Throws std::logic_error where it has one of them already,
/// with another schema.
const Schema& scene_schema();

/// Reads what stands under these keys. REQUIRES that all else of the scene is there.
void read_keys_of_effects(Scene& scene, SceneSource& source);

/// What the scene has under a key, null where it has none. REQUIRES that `Section` is what the key's read()
/// makes.
template <typename Section>
const Section* section_of(const Scene& scene, std::string_view key) {
  const auto found = scene.sections.find(key);
  return found == scene.sections.end() ? nullptr : static_cast<const Section*>(found->second.get());
}

}  // namespace tps
