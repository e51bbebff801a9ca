// What may be done to any scene to make it worse.
#pragma once

#include "properties/campaign/draw.hpp"
#include "properties/campaign/nasty_scenes.hpp"

namespace tps::properties::campaign {

/// Perhaps one change or more; each is added to the scene's kind. The result may be invalid.
void change(Draw& draw, NastyScene& made);

}  // namespace tps::properties::campaign
