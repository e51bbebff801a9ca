// A scene that uses everything a state holds.
#pragma once

#include <algorithm>

#include "verify/scenes/terminal.hpp"

namespace tps {

/// The terminal in small: groups, tethers by draw that also break, phases, impulses, observed clusters, a
/// container of infinite mass.
inline Scene busy_scene(double grouped) {
  TerminalParams params;
  params.vesicles = 8;
  params.pairs = 16;
  params.membrane_radius = 12;
  params.form_probability = .6;
  params.break_probability = .3;
  params.grouped = grouped;
  params.impact_at = .5;
  params.duration = 3;
  Scene scene = build_terminal(params);
  const auto rules = std::find_if(scene.pairs.begin(), scene.pairs.end(), [](const PairLaw& law) {
    return law.tethering && law.tethering->form.when == FormRule::When::probability;
  });
  scene.phases = {{.from = .25,
                   .until = .75,
                   .species_a = rules->species_a,
                   .species_b = rules->species_b,
                   .form = FormRule{.when = FormRule::When::never},
                   .breaks = {}},
                  {.from = .5,
                   .until = 2,
                   .species_a = rules->species_a,
                   .species_b = rules->species_b,
                   .form = {},
                   .breaks = BreakRule{.when = BreakRule::When::always}}};
  return scene;
}

}  // namespace tps
