#include "verify/scenes/brownian.hpp"

#include "verify/scenes/gas.hpp"

namespace tps {

Scene build_brownian(const BrownianParams& params) {
  Scene scene = build_gas(gas_of(params));
  scene.title = "Vesicles moved by random impulses";
  scene.species[1].random_impulses = RandomImpulses{params.tau, params.shape, params.mean};
  return scene;
}

SceneBuilder brownian_builder() {
  using P = BrownianParams;
  return make_builder<P>(
      "brownian", "vesicles in a spherical membrane that random impulses keep moving",
      {{"particles", &P::particles, from_to(1, 1000000), "vesicles"},
       {"density", &P::density, from_to(1e-6, 1), "vesicles over the volume of the membrane"},
       {"temperature", &P::temperature, from_to(0, 1e6), "kT of the start velocities"},
       {"tau", &P::tau, finite_above(0), "mean waiting time of a vesicle between two impulses"},
       {"shape", &P::shape, finite_above(0), "of the gamma distribution of magnitudes"},
       {"mean", &P::mean, finite_above(0), "of the magnitudes; a vesicle has mass 1"},
       {"restitution", &P::restitution, from_to(0, 1), "c_rebound of two vesicles"},
       {"duration", &P::duration, above(0), "time simulated"},
       {"seed", &P::seed, {}, "of start velocities and impulses"}},
      &build_brownian);
}

}  // namespace tps
