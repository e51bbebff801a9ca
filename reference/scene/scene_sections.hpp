// The sections of a scene file, each turned into its structures.
#pragma once

#include "reference/scene/scene.hpp"
#include "reference/scene/scene_source.hpp"

namespace tps {

/// Fills a scene from a value whose shape the schema has accepted in every section that is sound. Resolves
/// names and ids, fills in defaults, sorts the particles by id. Reports: unknown names and ids, vectors of
/// the wrong length, a pair of species or an id that stands twice. Sections that need an unsound one are not
/// read.
Scene read_sections(SceneSource& source);

}  // namespace tps
