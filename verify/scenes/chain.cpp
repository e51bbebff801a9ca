#include "verify/scenes/chain.hpp"

#include "verify/scenes/thermal.hpp"

namespace tps {

Scene build_chain(const ChainParams& params) {
  Scene scene;
  scene.title = "A protein: beads tethered to their neighbours";
  scene.duration = params.duration;
  scene.seed = params.seed;
  scene.species = {{.name = "bead", .mass = 1, .radius = 0.5, .max_tethers = {}}};
  scene.pairs = {{.species_a = 0,
                  .species_b = 0,
                  .blocking = BlockingLaw{.distance = 1, .c_rebound = params.c_rebound},
                  .tethering = TetheringLaw{.distance = params.tether_distance,
                                            .c_retract = params.c_retract,
                                            .c_revolve = params.c_revolve,
                                            .theta_revolve_deg = params.theta,
                                            .form = {.when = FormRule::When::never},
                                            .breaks = {.when = BreakRule::When::never}}}};
  if (params.grouped > 0) scene.grouping = Grouping{params.grouped};

  const double spacing = (1 + params.tether_distance) / 2;
  for (int i = 0; i < params.particles; ++i) {
    scene.particles.push_back({.id = i,
                               .species = 0,
                               .position = {(i - (params.particles - 1) / 2.0) * spacing, 0, 0},
                               .velocity = {}});
    if (i > 0) scene.tethers.push_back({i - 1, i});
  }
  return with_thermal_velocities(scene, params.temperature);
}

SceneBuilder chain_builder() {
  using P = ChainParams;
  return make_builder<P>(
      "chain", "a protein: beads tethered to their neighbours, with thermal velocities",
      {{"particles", &P::particles, from_to(2, 1000000), "beads"},
       {"tether-distance", &P::tether_distance, from_to(1.0001, 2), "outer limit, in bead diameters"},
       {"temperature", &P::temperature, from_to(0, 1e6), "kT of the start velocities; a bead has mass 1"},
       {"c-rebound", &P::c_rebound, from_to(0, 1), "restitution where beads collide"},
       {"c-retract", &P::c_retract, from_to(0, 1), "restitution where a tether retracts"},
       {"c-revolve", &P::c_revolve, from_to(0, 1), "speed kept over a revolution"},
       {"theta", &P::theta, from_to(1e-6, 90 - 1e-6), "angle of revolution, in degrees"},
       {"grouped", &P::grouped, from_to(0, 1e6), "dt_restitute of grouping; 0: no grouping"},
       {"duration", &P::duration, above(0), "time simulated"},
       {"seed", &P::seed, {}, "of the start velocities"}},
      &build_chain);
}

}  // namespace tps
