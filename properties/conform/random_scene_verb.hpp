// tps scene random: the scenes of `tps conform --simulator`, one by one.
#pragma once

#include <CLI/CLI.hpp>

namespace tps::cli {

/// Adds `random` to the verb `scene`, whose other scenes know nothing of this folder.
void add_random_scene(CLI::App& scene_verb);

}  // namespace tps::cli
