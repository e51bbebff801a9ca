// The catalogue of parametrised scenes.
#pragma once

#include <string>
#include <vector>

#include "verify/scenes/builder.hpp"

namespace tps {

/// Every parametrised scene, in the order in which help texts list them.
const std::vector<SceneBuilder>& scene_builders();

/// The scene of that name. Throws std::invalid_argument that lists the names there are.
const SceneBuilder& scene_builder(const std::string& name);

}  // namespace tps
