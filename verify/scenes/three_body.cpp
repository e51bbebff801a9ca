#include "verify/scenes/three_body.hpp"

#include <limits>

namespace tps {

Scene build_three_body(const ThreeBodyParams& params) {
  Scene scene;
  scene.title = "X meets Y, Y meets Z: nearly simultaneous collisions";
  scene.dimension = 2;
  scene.duration = std::numeric_limits<double>::infinity();
  scene.species = {{.name = "X", .mass = 1, .radius = 0.5, .max_tethers = {}},
                   {.name = "Y", .mass = params.middle_mass, .radius = 0.25, .max_tethers = {}},
                   {.name = "Z", .mass = 1, .radius = 0.5, .max_tethers = {}}};
  const BlockingLaw law{.distance = 0.75, .c_rebound = params.restitution};
  scene.pairs = {{.species_a = 0, .species_b = 1, .blocking = law, .tethering = {}},
                 {.species_a = 1, .species_b = 2, .blocking = law, .tethering = {}}};
  scene.particles = {{.id = 0, .species = 0, .position = {-1.75, 0, 0}, .velocity = {1, 0, 0}},
                     {.id = 1, .species = 1, .position = {0, 0, 0}, .velocity = {}},
                     {.id = 2, .species = 2, .position = {0.75 + params.gap, 0, 0}, .velocity = {}}};
  if (params.grouped > 0) {
    scene.grouping = Grouping{params.grouped};
    scene.duration = 2 + 4 * params.grouped;
  }
  return scene;
}

SceneBuilder three_body_builder() {
  using P = ThreeBodyParams;
  return make_builder<P>(
      "three-body",
      "the paper's X-Y-Z on a line: 70 collisions, a stall below e_c, 2 collisions when grouped",
      {{"middle-mass", &P::middle_mass, above(0), "mass of Y; X and Z have 1"},
       {"restitution", &P::restitution, from_to(0, 1), "c_rebound of both pairs"},
       {"gap", &P::gap, from_to(0, 0.75), "between Y and Z at the start"},
       {"grouped", &P::grouped, from_to(0, 1e6),
        "dt_restitute of grouping, above gap·(1 + m_Y) for one group of all three; 0: no grouping"}},
      &build_three_body);
}

}  // namespace tps
