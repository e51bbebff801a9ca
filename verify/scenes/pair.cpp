#include "verify/scenes/pair.hpp"

namespace tps {

Scene build_pair(const PairParams& params) {
  Scene scene;
  scene.title = "A revolving pair";
  scene.dimension = 2;
  scene.duration = params.duration;
  scene.species = {{.name = "particle", .mass = 1, .radius = 0.25, .max_tethers = {}}};
  scene.pairs = {{.species_a = 0,
                  .species_b = 0,
                  .blocking = BlockingLaw{.distance = 0.5, .c_rebound = 1},
                  .tethering = TetheringLaw{.distance = 1,
                                            .c_retract = params.c_retract,
                                            .c_revolve = params.c_revolve,
                                            .theta_revolve_deg = params.theta,
                                            .form = {.when = FormRule::When::never},
                                            .breaks = {.when = BreakRule::When::never}}}};
  scene.particles = {{.id = 0, .species = 0, .position = {-0.5, 0, 0}, .velocity = {0, -params.speed / 2, 0}},
                     {.id = 1, .species = 0, .position = {0.5, 0, 0}, .velocity = {0, params.speed / 2, 0}}};
  scene.tethers = {{0, 1}};
  return scene;
}

SceneBuilder pair_builder() {
  using P = PairParams;
  return make_builder<P>(
      "pair", "two particles circling on a taut tether: revolution, eq. (5)",
      {{"theta", &P::theta, from_to(1e-6, 90 - 1e-6), "angle of revolution, in degrees"},
       {"c-revolve", &P::c_revolve, from_to(0, 1), "speed kept over a revolution"},
       {"c-retract", &P::c_retract, from_to(0, 1), "restitution where the tether retracts"},
       {"speed", &P::speed, above(0, 1e100), "relative speed at the start"},
       {"duration", &P::duration, above(0), "time simulated"}},
      &build_pair);
}

}  // namespace tps
