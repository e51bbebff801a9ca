// Random impulses: each particle of a species is pushed at exponential times, with a gamma-distributed
// magnitude in a uniform direction. A vesicle that nothing else keeps moving moves by them.
//
// Laws: (1) waiting times have mean τ; (2) ⟨K⟩ of a free particle grows by ⟨J²⟩/(2mτ) a unit of time, ⟨J²⟩ =
// mean² (1 + 1/shape); (3) no other event changes when they come or what they are.
#pragma once

#include "reference/engine/effect_records.hpp"
#include "reference/engine/poisson_kicks.hpp"

namespace tps::effects {

template <typename Scalar, int D>
class RandomImpulseKicks final : public PoissonKicks<Scalar, D> {
 public:
  RandomImpulseKicks() : PoissonKicks<Scalar, D>("random_impulse", Rank{40}, Purpose::random_impulse) {}
  std::string_view name() const override { return "random_impulses"; }

 private:
  double mean_wait(const Species& species) const override {
    return species.random_impulses ? species.random_impulses->tau : 0;
  }
  Vector<Scalar, D> impulse(const World<Scalar, D>& world, int i, std::uint32_t n) const override {
    return lifted<Scalar, D>(random_impulse(world.scene, world.scene.particles[world.index(i)], n));
  }
};

struct random_impulses {
  static EffectCall call(const Scene& scene) {
    const auto calls = [](const Species& species) { return species.random_impulses.has_value(); };
    return {"random_impulses", "impulses of random size and direction at random times",
            species_that(scene, calls), "a species with \"random_impulses\"",
            std::to_string(particles_that(scene, calls)) + " particles with an event ahead each"};
  }
  static EffectRecords records(const Scene&) {
    return {
        .kinds = {{"random_impulse", About::particle}},
        .quantities = {{"random_impulses_heat"}},
        .draws = {
            {Purpose::random_impulse, [](const Scene& scene, const Particle& particle) {
               return scene.species[static_cast<std::size_t>(particle.species)].random_impulses.has_value();
             }}}};
  }
  template <typename Scalar, int D>
  static std::unique_ptr<Effect<Scalar, D>> make(const Scene&) {
    return std::make_unique<RandomImpulseKicks<Scalar, D>>();
  }
};

}  // namespace tps::effects
