// Rotation and friction: rough particles after Walton, with spins. docs/effects.md, "Rotation and friction".
//
// Laws: (1) spins change at rebounds of pairs with friction alone; (2) angular momentum, orbital and spin, is
// conserved at each; (3) energies of motion and spin lose what c_rebound, μ and β₀ say, nothing where
// c_rebound = 1, β₀ = ±1 and the surfaces stick.
#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include "reference/engine/effect.hpp"
#include "reference/engine/effect_records.hpp"
#include "reference/engine/energy.hpp"
#include "reference/engine/spin_coupling.hpp"
#include "reference/engine/state_numbers.hpp"

namespace tps::effects {

/// Takes the place of eq. (3), and has no event of its own.
template <typename Scalar, int D>
class FrictionEffect final : public Effect<Scalar, D> {
 public:
  FrictionEffect() : Effect<Scalar, D>({"lost"}) {}
  std::string_view name() const override { return "friction"; }
  void begin(World<Scalar, D>& world, int) override {
    auto coupling = std::make_unique<SpinCoupling<Scalar, D>>(world.scene, this->energy_share(0));
    coupling_ = coupling.get();
    if (!is_finite(Scalar(coupling_->energy(world) + kinetic_energy(world))))
      throw OutOfRange("the energy of motion and spins at the start");
    world.coupling = std::move(coupling);
  }
  void respond(World<Scalar, D>&, const PendingEvent<Scalar>&) override {}

  void save(const World<Scalar, D>& world, StateData& state) const override {
    for (int i = 0; i < world.size(); ++i) {
      if (!keeps_spin(world.scene, world.species(i))) continue;
      state.particles[world.index(i)].spin = detail::vector_data<Scalar, kSpin>(coupling_->spin(i));
    }
  }
  void load(World<Scalar, D>&, const StateData& state, const IndexOfId& index_of) override {
    for (const StateData::Particle& p : state.particles) {
      if (!p.spin.empty()) coupling_->set_spin(index_of.at(p.id), detail::vector_from<Scalar, kSpin>(p.spin));
    }
  }

 private:
  static constexpr int kSpin = SpinCoupling<Scalar, D>::kSize;
  SpinCoupling<Scalar, D>* coupling_ = nullptr;  ///< owned by the world
};

struct friction {
  static EffectCall call(const Scene& scene) {
    EffectCall call{
        "friction", "rough particles rub and turn each other (Walton)", {}, "a pair with \"friction\"", {}};
    std::vector<bool> turns(scene.species.size(), false);
    for (const PairLaw& pair : scene.pairs) {
      if (!pair.friction) continue;
      call.because.push_back(between(scene, pair));
      turns[static_cast<std::size_t>(pair.species_a)] = turns[static_cast<std::size_t>(pair.species_b)] =
          true;
    }
    const auto spinning =
        std::count_if(scene.particles.begin(), scene.particles.end(),
                      [&](const Particle& p) { return turns[static_cast<std::size_t>(p.species)]; });
    call.cost = std::to_string(spinning) + " particles with a spin";
    return call;
  }
  static EffectRecords records(const Scene&) { return {.quantities = {{"friction_lost"}}}; }
  template <typename Scalar, int D>
  static std::unique_ptr<Effect<Scalar, D>> make(const Scene&) {
    return std::make_unique<FrictionEffect<Scalar, D>>();
  }
};

}  // namespace tps::effects
