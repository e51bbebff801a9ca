// Small scenes at random, with the features that a simulator has.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "reference/scene/scene.hpp"
#include "reference/scene/write_scene.hpp"

namespace tps::properties::conform {

/// A feature and what it means that scenes have it, or do not.
struct FeatureFacts {
  std::string name, meaning;
};
const std::vector<FeatureFacts>& scene_features();

/// What --features says: "no-draws,no-groups,2d". Throws std::invalid_argument that names the word and lists
/// what there is, or names two words that exclude each other.
void check_features(const std::vector<std::string>& words);

/// Whether scenes have an effect of the outlook because of the word. REQUIRES check_features().
bool calls_for_effect(const std::string& word);
/// Those words.
std::vector<std::string> effect_words();

/// Scene `number` of a seed. It ends by its duration, or because nothing is left to happen, after at most a
/// hundred events of the reference; nothing where the number stands for one that collapses or leaves the
/// range. REQUIRES check_features().
std::optional<Scene> random_scene(const std::vector<std::string>& features, std::uint64_t seed,
                                  std::uint64_t number);

/// As a program is given it. One scene in ten leaves out what has a default: velocities of zero, distances of
/// the radii, rules for tethers. Law: (1) read_scene_text of it is the scene.
std::string text_of_random(const Scene& scene, SceneStyle style = SceneStyle::pretty);

}  // namespace tps::properties::conform
