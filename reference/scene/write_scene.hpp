// A scene as the text of a scene file.
#pragma once

#include <string>

#include "reference/scene/scene.hpp"

namespace tps {

enum class SceneStyle {
  compact,  ///< one line without spaces, no line end: for the header of a trace
  pretty,   ///< for people: one entry of a list a line, with a line end at the end
};

/// Numbers are the shortest decimals that read back as the same doubles. Defaults that depend on other values
/// (distances, ids) are written out; an absent option, an empty list and the defaults of title, start_time
/// and seed are left out. (1) read_scene_text(write_scene(s, style)) == s for every scene that read_scene
/// accepts.
std::string write_scene(const Scene& scene, SceneStyle style = SceneStyle::pretty);

}  // namespace tps
