// Andersen's thermostat (J. Chem. Phys. 72, 2384, 1980): at exponential times a particle forgets its velocity
// and gets one of the Maxwell distribution of kT.
//
// Laws: (1) waiting times have mean τ; (2) each component of the new velocity is normal with variance kT/m,
// whatever the old one; (3) no other event changes when it acts or what it draws.
#pragma once

#include "reference/engine/effect_records.hpp"
#include "reference/engine/poisson_kicks.hpp"

namespace tps::effects {

template <typename Scalar, int D>
class ThermostatKicks final : public PoissonKicks<Scalar, D> {
 public:
  ThermostatKicks() : PoissonKicks<Scalar, D>("thermostat", Rank{50}, Purpose::thermostat) {}
  std::string_view name() const override { return "thermostat"; }

 private:
  double mean_wait(const Species& species) const override {
    return species.thermostat ? species.thermostat->tau : 0;
  }
  /// What turns the present velocity into the new one.
  Vector<Scalar, D> impulse(const World<Scalar, D>& world, int i, std::uint32_t n) const override {
    const Vector<Scalar, D> v =
        lifted<Scalar, D>(maxwell_velocity(world.scene, world.scene.particles[world.index(i)], n));
    return world.mass(i) * (v - world.velocity(i));
  }
};

struct thermostat {
  static EffectCall call(const Scene& scene) {
    const auto calls = [](const Species& species) { return species.thermostat.has_value(); };
    return {"thermostat", "velocities drawn anew from a Maxwell distribution at random times",
            species_that(scene, calls), "a species with \"thermostat\"",
            std::to_string(particles_that(scene, calls)) + " particles with an event ahead each"};
  }
  static EffectRecords records(const Scene&) {
    return {
        .kinds = {{"thermostat", About::particle}},
        .quantities = {{"thermostat_heat"}},
        .draws = {{Purpose::thermostat, [](const Scene& scene, const Particle& particle) {
                     return scene.species[static_cast<std::size_t>(particle.species)].thermostat.has_value();
                   }}}};
  }
  template <typename Scalar, int D>
  static std::unique_ptr<Effect<Scalar, D>> make(const Scene&) {
    return std::make_unique<ThermostatKicks<Scalar, D>>();
  }
};

}  // namespace tps::effects
