#include "verify/scenes/sediment.hpp"

#include "verify/scenes/gas.hpp"

namespace tps {

Scene build_sediment(const SedimentParams& params) {
  Scene scene = build_gas(gas_of(params));
  scene.title = "Spheres that settle under gravity";
  scene.gravity = Gravity{{0, 0, -params.gravity}, params.every};
  if (params.tau > 0) scene.species[1].thermostat = Thermostat{params.tau, params.temperature};
  return scene;
}

SceneBuilder sediment_builder() {
  using P = SedimentParams;
  return make_builder<P>(
      "sediment", "spheres under gravity in a spherical membrane, thermalised if asked",
      {{"particles", &P::particles, from_to(1, 1000000), "spheres"},
       {"density", &P::density, from_to(1e-6, 1), "spheres over the volume of the membrane"},
       {"temperature", &P::temperature, from_to(1e-6, 1e6), "kT of the start velocities and the thermostat"},
       {"gravity", &P::gravity, from_to(1e-6, 1e6), "acceleration along -z"},
       {"every", &P::every, finite_above(0), "time between two impulses of gravity"},
       {"restitution", &P::restitution, from_to(0, 1), "c_rebound of two spheres"},
       {"tau", &P::tau, from_to(0, 1e6),
        "mean time of a sphere between two thermostat events; 0: no thermostat"},
       {"duration", &P::duration, above(0), "time simulated"},
       {"seed", &P::seed, {}, "of start velocities and thermostat"}},
      &build_sediment);
}

}  // namespace tps
