#include "verify/scenes/cradle.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace tps {

Scene build_cradle(const CradleParams& params) {
  if (params.moving > params.particles) {
    throw std::invalid_argument(fmt::format("--moving is {}; allowed is an integer from 0 to --particles, {}",
                                            params.moving, params.particles));
  }
  Scene scene;
  scene.title = "Newton's cradle";
  scene.dimension = 2;
  scene.duration = params.duration;
  scene.species = {{.name = "ball", .mass = 1, .radius = 0.05, .max_tethers = {}}};
  scene.pairs = {{.species_a = 0,
                  .species_b = 0,
                  .blocking = BlockingLaw{.distance = 0.05 + 0.05, .c_rebound = params.restitution},
                  .tethering = {}}};
  for (int i = 0; i < params.particles; ++i) {
    scene.particles.push_back({.id = i,
                               .species = 0,
                               .position = {0.1 * i, 0, 0},
                               .velocity = {i < params.moving ? 1.0 : 0.0, 0, 0}});
  }
  return scene;
}

SceneBuilder cradle_builder() {
  using P = CradleParams;
  return make_builder<P>("cradle", "Newton's cradle: touching balls in a row, struck at one end",
                         {{"particles", &P::particles, from_to(1, 1000000), "balls"},
                          {"moving", &P::moving, from_to(0, 1000000), "of them, at one end, with velocity 1"},
                          {"restitution", &P::restitution, from_to(0, 1), "c_rebound"},
                          {"duration", &P::duration, above(0), "time simulated"}},
                         &build_cradle);
}

}  // namespace tps
