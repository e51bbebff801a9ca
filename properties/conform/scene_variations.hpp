// What makes a random scene harder to get through by luck: a clock that does not start at 0, tethers that
// have to form, thresholds beside an impulse that occurs.
#pragma once

#include <rapidcheck.h>

#include <vector>

#include "properties/runs/outlook_scenes.hpp"
#include "properties/runs/scenes.hpp"

namespace tps::properties::conform {

/// What the words of --features ask for.
struct Wishes : runs::Wanted {
  bool start_time = true;
  bool contacts = false;                    ///< pairs that touch and move across, and nothing else
  std::vector<runs::Outlook> outlook = {};  ///< each scene calls for one of them at least
};

/// True once in so many draws.
bool once_in(std::uint64_t many, rc::Random& stream);

/// Perhaps without the tethers that it starts with, so that they have to form, and particles that hold one or
/// two of them.
Scene untethered(Scene scene, const Wishes& wanted, rc::Random& stream);

/// Perhaps with tethers of one pair of species that break above an impulse: 1 % above or below the |Δp| of a
/// tethering collision of the reference's run that none before it exceeds. The run is the same up to there.
Scene with_near_threshold(Scene scene, const Wishes& wanted, rc::Random& stream);

/// Perhaps with radii that no distance follows from, and with pairs that block each other tethered for ever
/// where that can be.
Scene with_other_limits(Scene scene, const Wishes& wanted, rc::Random& stream);

/// With ids that are neither places in the list nor ascending.
Scene with_other_ids(Scene scene, rc::Random& stream);

/// Perhaps with a start_time, which shifts no other time of the scene.
Scene with_start_time(Scene scene, const Wishes& wanted, rc::Random& stream);

}  // namespace tps::properties::conform
