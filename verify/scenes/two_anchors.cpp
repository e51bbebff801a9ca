#include "verify/scenes/two_anchors.hpp"

#include <limits>

namespace tps {

Scene build_two_anchors(const TwoAnchorsParams& params) {
  Scene scene;
  scene.title = "Two taut tethers on fixed particles";
  scene.dimension = 2;
  scene.duration = params.duration;
  scene.species = {
      {.name = "anchor", .mass = std::numeric_limits<double>::infinity(), .radius = 0.125, .max_tethers = {}},
      {.name = "particle", .mass = 1, .radius = 0.125, .max_tethers = {}}};
  scene.pairs = {{.species_a = 0,
                  .species_b = 1,
                  .blocking = BlockingLaw{.distance = 0.25, .c_rebound = 1},
                  .tethering = TetheringLaw{.distance = 1,
                                            .c_retract = params.c_retract,
                                            .c_revolve = 1,
                                            .theta_revolve_deg = 45,
                                            .form = {.when = FormRule::When::never},
                                            .breaks = {.when = BreakRule::When::never}}}};
  if (params.grouped > 0) scene.grouping = Grouping{params.grouped};
  scene.particles = {{.id = 0, .species = 0, .position = {-1, 0, 0}, .velocity = {}},
                     {.id = 1, .species = 0, .position = {1, 0, 0}, .velocity = {}},
                     {.id = 2, .species = 1, .position = {0, 0, 0}, .velocity = {params.speed, 0, 0}}};
  scene.tethers = {{0, 2}, {1, 2}};
  return scene;
}

SceneBuilder two_anchors_builder() {
  using P = TwoAnchorsParams;
  return make_builder<P>(
      "two-anchors", "a particle on two taut tethers: stalls ungrouped, goes on grouped",
      {{"speed", &P::speed, above(0, 1e100), "of the particle, towards one anchor"},
       {"c-retract", &P::c_retract, from_to(0, 1), "restitution where a tether retracts"},
       {"grouped", &P::grouped, from_to(0, 1e6), "dt_restitute of grouping; 0: no grouping"},
       {"duration", &P::duration, above(0), "time simulated"}},
      &build_two_anchors);
}

}  // namespace tps
