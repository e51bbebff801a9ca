#include "reference/scene/read_scene.hpp"

#include <utility>

#include "reference/scene/check_scene.hpp"
#include "reference/scene/scene_key.hpp"
#include "reference/scene/scene_sections.hpp"
#include "reference/scene/scene_source.hpp"
#include "reference/text/file_kind.hpp"
#include "reference/text/schema_validator.hpp"
#include "reference/text/text_file.hpp"

namespace tps {
namespace {

constexpr const char* too_large_remedy = "a scene of this size has too many particles for one run: use fewer";

// Adds to the problems that are known already, so that all of a file's come at once.
Scene read_value(const JsonValue& value, const std::string& prefix, InputProblems& problems) {
  scene_schema().validate(value, problems, prefix);
  SceneSource source(value, prefix, problems);
  Scene scene = read_sections(source);
  check_scene(scene, source);
  problems.throw_if_any();
  return scene;
}

Scene read_document(JsonDocument document) {
  return read_value(document.root, "", document.problems);
}

}  // namespace

SceneFile read_scene_with_places(const std::string& path) {
  const std::string text = read_text_file(path, kSceneLimits.max_bytes, too_large_remedy);
  refuse_other_kinds(text, display_name(path), "a scene", {FileKind::scene});
  JsonDocument document = parse_json(text, display_name(path), kSceneLimits);
  Scene scene = read_value(document.root, "", document.problems);
  return {std::move(scene), std::move(document.root)};
}

Scene read_scene_file(const std::string& path) {
  return read_scene_with_places(path).scene;
}

Scene read_scene_text(std::string_view text, const std::string& name) {
  return read_document(parse_json(text, name, kSceneLimits));
}

Scene read_scene_value(const JsonValue& value, const std::string& file, const std::string& pointer) {
  InputProblems problems(file);
  return read_value(value, pointer, problems);
}

}  // namespace tps
