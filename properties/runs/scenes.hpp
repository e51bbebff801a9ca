// Whole small scenes, every one valid, most of them at an edge: touching, taut, tied, crowded, heavy beside
// light.
#pragma once

#include <rapidcheck.h>

#include <iosfwd>

#include "reference/scene/scene.hpp"

namespace tps::properties::runs {

/// What a law needs of its scenes. The defaults allow everything.
struct Wanted {
  enum class Choice { maybe, always, never };
  Choice grouping = Choice::maybe;
  bool outside = true;  ///< impulses, and phases of rules; one of them alone:
  bool impulses = true, phases = true;
  bool tethers = true;      ///< enclosures among them
  bool draws = true;        ///< rules that decide with a probability
  bool dissipation = true;  ///< coefficients below 1, and revolution at more than 1e-6 degrees
  bool changing_tethers = true;
  bool infinite_masses = true;
  bool ties = true;     ///< starts at limits, alignments and whole numbers, which make events simultaneous
  bool gravity = true;  ///< beside another effect of the outlook (outlook_scenes.hpp)
  int dimension = 0;    ///< 2 or 3; 0: either
};

/// A scene as a generator made it; printed as the text of a scene file, which `tps run -` takes.
struct SmallScene {
  Scene scene;
};
std::ostream& operator<<(std::ostream& out, const SmallScene& small);

/// Scenes of 2 to 8 particles on a piece of a lattice (pair, row, ring, sheet, cube), of up to three species
/// with masses over 24 decades, perhaps with walls and an enclosure of infinite mass; tethered along its
/// edges, or some of them. Shrinks towards two resting particles, one species, no law that the failure does
/// not need, small whole numbers, duration 1. Law: (1) read_scene_text accepts what write_scene writes of
/// each, and returns the same.
rc::Gen<SmallScene> small_scene(const Wanted& wanted = {});

}  // namespace tps::properties::runs
