// Rules earliest and impulse, for impulses at random times.
#pragma once

#include <limits>

#include "verify/trace_check/rules/random_times.hpp"

namespace tps::check::effects {

template <typename Number>
class RandomImpulses final : public RandomTimes<Number> {
 public:
  explicit RandomImpulses(const Scene& scene) : RandomTimes<Number>(Purpose::random_impulse) {
    this->add_particles(scene, Purpose::random_impulse_wait, [](const Species& species) {
      return species.random_impulses ? std::optional(species.random_impulses->tau) : std::nullopt;
    });
  }
  std::string_view effect() const override { return "random_impulses"; }
  int rank() const override { return 40; }
  std::string what() const override { return "random impulse"; }

 private:
  /// That of the scene, rounded once; those of a shape below 1 have passed through a power, which C libraries
  /// give to an ulp or so.
  KickImpulse<Number> impulse(const Context<Number>& c, const EventAhead& next) const override {
    using W = Work<Number>;
    const Scene& scene = c.model.scene;
    const Particle& particle = scene.particles[Model<Number>::at(next.particle)];
    const Vec<W> J = stored_vector(c, random_impulse(scene, particle, next.number));
    const auto& law = scene.species[Model<Number>::at(particle.species)].random_impulses;
    constexpr double kUlpsOfPower = 4 * std::numeric_limits<double>::epsilon();
    return {J, law->shape < 1 ? W(kUlpsOfPower) * largest(J) : W(0)};
  }
};

struct random_impulses {
  template <typename Number>
  static std::unique_ptr<EffectRules<Number>> make(const Scene& scene) {
    return std::make_unique<RandomImpulses<Number>>(scene);
  }
};

}  // namespace tps::check::effects
