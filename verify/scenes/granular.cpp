#include "verify/scenes/granular.hpp"

#include "verify/scenes/gas.hpp"

namespace tps {

Scene build_granular(const GranularParams& params) {
  Scene scene = build_gas(gas_of(params));
  scene.title = "A granular gas that cools";
  for (PairLaw& law : scene.pairs) {
    if (law.blocking && params.mu > 0) law.friction = FrictionLaw{params.mu, params.beta0};
  }
  return scene;
}

SceneBuilder granular_builder() {
  using P = GranularParams;
  return make_builder<P>(
      "granular", "inelastic spheres that cool in an elastic spherical membrane",
      {{"particles", &P::particles, from_to(1, 1000000), "spheres"},
       {"density", &P::density, from_to(1e-6, 1), "spheres over the volume of the membrane"},
       {"temperature", &P::temperature, from_to(1e-6, 1e6), "kT of the start velocities"},
       {"restitution", &P::restitution, from_to(0, 1), "c_rebound of two spheres"},
       {"mu", &P::mu, from_to(0, 1e12), "coefficient of friction; 0: smooth spheres"},
       {"beta0", &P::beta0, from_to(-1, 1), "tangential restitution of surfaces that stick"},
       {"duration", &P::duration, above(0), "time simulated"},
       {"seed", &P::seed, {}, "of start velocities"}},
      &build_granular);
}

}  // namespace tps
