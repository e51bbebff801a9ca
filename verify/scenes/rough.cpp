#include "verify/scenes/rough.hpp"

#include "verify/scenes/gas.hpp"

namespace tps {

Scene build_rough(const RoughParams& params) {
  Scene scene = build_gas(gas_of(params));
  scene.title = "Rough spheres in a spherical membrane";
  for (PairLaw& law : scene.pairs) {
    if (law.blocking) law.friction = FrictionLaw{params.mu, params.beta0};
  }
  for (std::size_t i = 0; i < scene.particles.size(); ++i) {
    const Particle& p = scene.particles[i];
    if (p.species == 1 && p.id % 2 == 0) set_spin(scene, i, {0, 0, p.id % 4 == 0 ? 1. : -1.});
  }
  return scene;
}

SceneBuilder rough_builder() {
  using P = RoughParams;
  return make_builder<P>(
      "rough", "rough spheres that turn each other in a spherical membrane",
      {{"particles", &P::particles, from_to(1, 1000000), "spheres"},
       {"density", &P::density, from_to(1e-6, 1), "spheres over the volume of the membrane"},
       {"temperature", &P::temperature, from_to(1e-6, 1e6), "kT of the start velocities"},
       {"restitution", &P::restitution, from_to(0, 1), "c_rebound of two spheres"},
       {"mu", &P::mu, from_to(0, 1e12), "coefficient of friction"},
       {"beta0", &P::beta0, from_to(-1, 1), "tangential restitution of surfaces that stick"},
       {"duration", &P::duration, above(0), "time simulated"},
       {"seed", &P::seed, {}, "of start velocities"}},
      &build_rough);
}

}  // namespace tps
