// Rules earliest and impulse, for Andersen's thermostat.
#pragma once

#include "verify/trace_check/rules/random_times.hpp"

namespace tps::check::effects {

template <typename Number>
class Thermostat final : public RandomTimes<Number> {
 public:
  explicit Thermostat(const Scene& scene) : RandomTimes<Number>(Purpose::thermostat) {
    this->add_particles(scene, Purpose::thermostat_wait, [](const Species& species) {
      return species.thermostat ? std::optional(species.thermostat->tau) : std::nullopt;
    });
  }
  std::string_view effect() const override { return "thermostat"; }
  int rank() const override { return 50; }
  std::string what() const override { return "thermostat"; }

 private:
  /// m (v' − v), v' drawn: a subtraction and a product, or m v' − m v; with v' as it is drawn, or as v + Δp/m
  /// is stored: u m (|v| + |v'|) and four of Δp.
  KickImpulse<Number> impulse(const Context<Number>& c, const EventAhead& next) const override {
    using W = Work<Number>;
    const Model<Number>& model = c.model;
    const Particle& particle = model.scene.particles[Model<Number>::at(next.particle)];
    const Vec<W> v = stored_vector(c, maxwell_velocity(model.scene, particle, next.number));
    const W inverse_mass = model.inverse_mass(next.particle);
    const Vec<W> before = widened<W>(model.flight(next.particle).velocity);
    const Vec<W> change = v - before;
    const Vec<W> J = (W(1) / inverse_mass) * change;
    const W drift = model.flight(next.particle).drift;
    const W rounding = W(4) * largest(J) + (largest(before) + largest(v)) / inverse_mass;
    return {J, c.u() * rounding + drift / inverse_mass + model.precision.smallest};
  }
};

struct thermostat {
  template <typename Number>
  static std::unique_ptr<EffectRules<Number>> make(const Scene& scene) {
    return std::make_unique<Thermostat<Number>>(scene);
  }
};

}  // namespace tps::check::effects
