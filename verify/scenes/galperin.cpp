#include "verify/scenes/galperin.hpp"

#include <limits>

namespace tps {

Scene build_galperin(const GalperinParams& params) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  double heavy = 1;
  for (int i = 0; i < params.digits; ++i) heavy *= 100;  // exact: 100^10 = 5^20·2^20, and 5^20 < 2^53

  Scene scene;
  scene.title = "Galperin: two balls and a wall count the digits of pi";
  scene.dimension = 2;
  scene.duration = kInfinity;
  scene.species = {{.name = "wall", .mass = kInfinity, .radius = 0.5, .max_tethers = {}},
                   {.name = "light", .mass = 1, .radius = 0.5, .max_tethers = {}},
                   {.name = "heavy", .mass = heavy, .radius = 0.5, .max_tethers = {}}};
  const BlockingLaw elastic{.distance = 1, .c_rebound = 1};
  scene.pairs = {{.species_a = 0, .species_b = 1, .blocking = elastic, .tethering = {}},
                 {.species_a = 1, .species_b = 2, .blocking = elastic, .tethering = {}}};
  scene.particles = {{.id = 0, .species = 0, .position = {0, 0, 0}, .velocity = {}},
                     {.id = 1, .species = 1, .position = {2, 0, 0}, .velocity = {}},
                     {.id = 2, .species = 2, .position = {4, 0, 0}, .velocity = {-params.speed, 0, 0}}};
  return scene;
}

SceneBuilder galperin_builder() {
  using P = GalperinParams;
  return make_builder<P>(
      "galperin", "two balls and a wall, whose collisions count the digits of π",
      {{"digits", &P::digits, from_to(0, 10),
        "of π after the point: the heavy ball weighs 100^digits, 3·10^digits collisions follow"},
       {"speed", &P::speed, above(0, 1e100), "of the heavy ball, towards the wall"}},
      &build_galperin);
}

}  // namespace tps
