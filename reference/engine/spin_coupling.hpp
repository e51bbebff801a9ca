// Collisions of particles that keep a spin: eq. (4) along the axis, friction across it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "reference/engine/coupling.hpp"
#include "reference/engine/energy_share.hpp"
#include "reference/engine/world.hpp"
#include "reference/equations/rough_impulse.hpp"
#include "reference/equations/weighted_square.hpp"

namespace tps {

/// Eq. (3) at once, as without friction; at an inner limit with friction Δp has J_t, too, and spins change.
/// Spins are kept here, so that a run without friction has none.
template <typename Scalar, int D>
class SpinCoupling final : public FreeCoupling<Scalar, D> {
 public:
  using Vec = Vector<Scalar, D>;
  using SpinVec = Spin<Scalar, D>;
  static constexpr int kSize = D == 2 ? 1 : 3;

  /// @param lost  takes up what friction turns into heat; outlives the coupling
  SpinCoupling(const Scene& scene, EnergyShare<Scalar>& lost)
      : species_(scene.species.size()),
        friction_(species_ * species_),
        spins_(scene.particles.size()),
        lost_(lost) {
    for (const PairLaw& law : scene.pairs) {
      if (!law.friction) continue;
      const Friction friction{Scalar(law.friction->mu), Scalar(law.friction->beta0)};
      friction_[place(law.species_a, law.species_b)] = friction_[place(law.species_b, law.species_a)] =
          friction;
    }
    for (const Species& species : scene.species) radii_.push_back(Scalar(species.radius));
    for (std::size_t i = 0; i < spins_.size(); ++i) {
      for (int k = 0; k < kSize; ++k) spins_[i][k] = Scalar(spin_of(scene, i)[static_cast<std::size_t>(k)]);
    }
  }

  const SpinVec& spin(int i) const { return spins_[World<Scalar, D>::index(i)]; }
  /// Takes up a spin from outside: a full state's.
  void set_spin(int i, const SpinVec& spin) { spins_[World<Scalar, D>::index(i)] = spin; }

  /// ½ Σ I ω², I = K m R².
  Scalar energy(const World<Scalar, D>& world) const {
    Sum<Scalar> sum;
    for (int i = 0; i < world.size(); ++i) {
      if (!world.fixed(i)) sum += energy_of_spin(world, i);
    }
    return sum.value();
  }

  std::optional<SpinEnergies<Scalar>> spin_energies(const World<Scalar, D>& world) const override {
    return SpinEnergies<Scalar>{SpinCoupling(world.scene, lost_).energy(world), energy(world)};
  }

  void collide(World<Scalar, D>& world, const Collision<Scalar, D>& c, Record<Scalar, D>& record) override {
    const auto& friction = friction_[place(world.species(c.i), world.species(c.j))];
    if (c.limit != Limit::inner || !friction) return FreeCoupling<Scalar, D>::collide(world, c, record);
    const SpinVec surface = radius(world, c.i) * spin(c.i) + radius(world, c.j) * spin(c.j);
    const RoughImpulse<Scalar, D> rough = rough_impulse<Scalar, D>(
        c.frame, c.mass_i, c.mass_j, norm<Scalar, D>(c.dp), surface, friction->mu, friction->beta0);
    Collision<Scalar, D> whole = c;
    whole.dp += rough.dp;
    record.dp = whole.dp;
    addition_.sticks = rough.sticks;
    addition_.spins.clear();
    record.addition = &addition_;
    FreeCoupling<Scalar, D>::collide(world, whole, record);
    world.ledger.lost += rough.lost;
    lost_.add(rough.lost, "friction");
    for (const ParticleChange<Scalar, D>& side : record.involved) turn(world, side, c.frame.u_hat, rough.dp);
  }

 private:
  struct Friction {
    Scalar mu, beta0;
  };

  std::size_t place(int a, int b) const {
    return static_cast<std::size_t>(a) * species_ + static_cast<std::size_t>(b);
  }
  const Scalar& radius(const World<Scalar, D>& world, int i) const {
    return radii_[World<Scalar, D>::index(world.species(i))];
  }
  /// ½ K m |R ω|²: of the surface's speed, since neither R² nor ω² need be in the range of the scalar.
  Scalar energy_of_spin(const World<Scalar, D>& world, int i) const {
    const SpinVec surface = radius(world, i) * spin(i);
    return inertia_ratio<Scalar, D>() * weighted_square<Scalar, kSize>(world.mass(i), surface) / Scalar(2);
  }

  /// Infinite masses do not turn. The ledger's bound of a velocity is taken for R ω, too (docs/ledger.md).
  void turn(World<Scalar, D>& world, const ParticleChange<Scalar, D>& side, const Vector<Scalar, D>& u_hat,
            const Vector<Scalar, D>& dp) {
    const int i = side.particle;
    if (world.fixed(i)) return;
    const SpinVec before = spin(i);
    const SpinVec after = before + spin_change<Scalar, D>(u_hat, dp, world.mass(i), radius(world, i));
    if (!is_finite<Scalar, kSize>(after)) throw OutOfRange("the spin of " + particle_name(world.scene, i));
    set_spin(i, after);
    addition_.spins.push_back({i, {before.begin(), before.end()}, {after.begin(), after.end()}});
    const Vec& V = world.frame_velocity();
    const Vec& v = world.velocity(i);
    const Scalar speeds = norm<Scalar, D>(side.velocity_before) + norm<Scalar, D>(v);
    const Scalar in_frame = norm<Scalar, D>(side.velocity_before - V) + norm<Scalar, D>(v - V);
    const Scalar larger = std::max(speeds, in_frame) +
                          radius(world, i) * Scalar(norm<Scalar, kSize>(before) + norm<Scalar, kSize>(after));
    const Scalar units = Scalar(32) * std::numeric_limits<Scalar>::epsilon();  // 64 u
    world.ledger.energy_bound += units * world.mass(i) * larger * larger;
  }

  std::size_t species_;
  std::vector<std::optional<Friction>> friction_;  ///< by two species
  std::vector<Scalar> radii_;                      ///< by species
  std::vector<SpinVec> spins_;
  EnergyShare<Scalar>& lost_;
  Addition<Scalar, D> addition_;  ///< to the record of the last rebound with friction
};

}  // namespace tps
