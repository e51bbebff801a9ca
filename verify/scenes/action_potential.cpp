#include "verify/scenes/action_potential.hpp"

#include <algorithm>
#include <string>

namespace tps {

Scene build_action_potential(const ActionPotentialParams& params) {
  TerminalParams terminal;
  terminal.vesicles = params.vesicles;
  terminal.pairs = params.pairs;
  terminal.membrane_radius = params.membrane_radius;
  terminal.temperature = params.temperature;
  terminal.form_probability = params.form_probability;
  terminal.impacts = 0;
  terminal.grouped = params.grouped;
  terminal.duration = params.duration;
  terminal.seed = params.seed;
  Scene scene = build_terminal(terminal);
  scene.title = "A presynaptic terminal while an action potential passes: clusters fall apart and form again";

  const auto of_name = [&](const std::string& name) {
    const auto named = [&](const Species& species) { return species.name == name; };
    return static_cast<int>(std::find_if(scene.species.begin(), scene.species.end(), named) -
                            scene.species.begin());
  };
  scene.phases = {{.from = params.potential_at,
                   .until = params.potential_at + params.potential_for,
                   .species_a = of_name("vesicle"),
                   .species_b = of_name("synapsin"),
                   .form = FormRule{.when = FormRule::When::never},
                   .breaks = BreakRule{.when = BreakRule::When::always}}};
  return scene;
}

SceneBuilder action_potential_builder() {
  using P = ActionPotentialParams;
  return make_builder<P>(
      "terminal-action-potential",
      "the terminal of Figure 1 while an action potential passes: clusters fall apart and form again",
      {{"vesicles", &P::vesicles, from_to(1, 10000), "vesicles"},
       {"pairs", &P::pairs, from_to(0, 1000000), "pairs of synapsins; clusters need about two a vesicle"},
       {"membrane-radius", &P::membrane_radius, above(0, 1e6), "in synapsin radii"},
       {"temperature", &P::temperature, from_to(0, 1e6), "kT of the start velocities; a synapsin has mass 1"},
       {"form-probability", &P::form_probability, from_to(0, 1),
        "that a vesicle-synapsin collision tethers, but for the phase"},
       {"potential-at", &P::potential_at, from_to(0, 1e9), "when tethers begin to break"},
       {"potential-for", &P::potential_for, above(0, 1e9), "how long they do, and none forms"},
       {"grouped", &P::grouped, from_to(0, 1e6), "dt_restitute of grouping; 0: no grouping"},
       {"duration", &P::duration, above(0), "time simulated"},
       {"seed", &P::seed, {}, "of places and start velocities"}},
      &build_action_potential);
}

}  // namespace tps
