// Scenes for the campaign: nothing that a user would draw, all that arithmetic is bad at.
#pragma once

#include <cstdint>
#include <string>

#include "reference/scene/scene.hpp"

namespace tps::properties::campaign {

/// A scene and the kind of trouble that it was made for.
struct NastyScene {
  std::string kind;
  Scene scene;
};

/// Scene number `n` of a seed, always the same one on every machine: whole numbers (ties, resting contacts,
/// corners of walls), rings and chains on taut tethers, heavy beside light, gases in an enclosure, and the
/// small scenes of the laws of runs; then perhaps dead coefficients, angles at their ends, moving walls,
/// large coordinates, scales up to 2^±300, groups of every age, phases and impulses at the times of the
/// collisions, thresholds at the impulses that occur. Law: read_scene_text accepts it.
NastyScene nasty_scene(std::uint64_t seed, std::uint64_t n);

/// Whether a scalar tells places of the scene apart that its limits do, and holds its squares; float and
/// wider ones are asked for what they can.
bool is_resolved(const Scene& scene, const std::string& scalar, const std::string& timing);

}  // namespace tps::properties::campaign
