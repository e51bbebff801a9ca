// From a scene file to a scene that can be simulated.
#pragma once

#include <string>
#include <string_view>

#include "reference/scene/scene.hpp"
#include "reference/text/input_error.hpp"
#include "reference/text/json_document.hpp"

namespace tps {

/// What a scene file, or a first line that holds a scene, may cost at most: 10⁶ particles are 190 MB and 11
/// million values.
inline constexpr JsonLimits kSceneLimits{std::size_t{256} << 20, 64, 1000, 16'000'000};

/// Reads, validates and checks a scene; path "-" is the standard input. The format is docs/scene.md and
/// data/schemas/scene.schema.json.
///
/// Returns a scene that the engine may trust: every reference is an index that exists, every number is in
/// its range, defaults are filled in, particles are sorted by id, and no start violates a limit.
/// Throws InputError with everything that is wrong. What needs a broken part of the file to be checked (the
/// starts of particles whose species is misspelt) is left for the next attempt.
Scene read_scene_file(const std::string& path);

/// The same with the document, whose values know their lines.
struct SceneFile {
  Scene scene;
  JsonValue document;
};
SceneFile read_scene_with_places(const std::string& path);

/// The same for a text; `name` is what messages call it.
Scene read_scene_text(std::string_view text, const std::string& name);

/// The same for a value inside another document (the header of a trace); `file` and `pointer` say where it
/// stands.
Scene read_scene_value(const JsonValue& value, const std::string& file, const std::string& pointer);

}  // namespace tps
