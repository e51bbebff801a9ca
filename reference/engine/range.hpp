// The range of a run's scalar: no number of a run is ever infinite or NaN where it stands for something
// finite. Whoever meets one throws; the driver of the run ends it at the step before (docs/engine.md,
// "Range").
#pragma once

#include <limits>
#include <stdexcept>
#include <string>

#include "reference/engine/clock.hpp"
#include "reference/engine/ledger.hpp"
#include "reference/engine/record.hpp"
#include "reference/equations/vector.hpp"
#include "reference/scene/scene.hpp"

namespace tps {

/// A number left the range of the scalar. what() says which one: "the velocity of particle 3".
class OutOfRange : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

inline std::string particle_name(const Scene& scene, int i) {
  return "particle " + std::to_string(scene.particles[static_cast<std::size_t>(i)].id);
}
inline std::string pair_name(const Scene& scene, int i, int j) {
  return "particles " + std::to_string(scene.particles[static_cast<std::size_t>(i)].id) + " and " +
         std::to_string(scene.particles[static_cast<std::size_t>(j)].id);
}

/// Throws OutOfRange unless every number of an event is finite.
template <typename Scalar, int D>
void require_range(const Scene& scene, const Record<Scalar, D>& record) {
  const auto event = [&] { return " at their " + std::string(record.kind); };
  for (const ParticleChange<Scalar, D>& change : record.involved) {
    if (!is_finite<Scalar, D>(change.position))
      throw OutOfRange("the position of " + particle_name(scene, change.particle));
    if (!is_finite<Scalar, D>(change.velocity_after))
      throw OutOfRange("the velocity of " + particle_name(scene, change.particle) + " after its " +
                       std::string(record.kind));
  }
  if (record.dp && !is_finite<Scalar, D>(*record.dp))
    throw OutOfRange("the impulse between " + pair_name(scene, record.i, record.j) + event());
  if (const Addition<Scalar, D>* added = record.addition) {
    if (added->dv && !is_finite<Scalar, D>(*added->dv))
      throw OutOfRange("the change of velocities" + event());
    if (added->dp_stored && !is_finite<Scalar, D>(*added->dp_stored))
      throw OutOfRange("the stored impulse of " + pair_name(scene, record.i, record.j) + event());
  }
  if (!is_finite(record.dt)) throw OutOfRange("the time since the event before");
}

/// Throws OutOfRange where an impulse on a particle's body, or the change of velocity that it makes there, is
/// rounded below the normal numbers: the error is then no longer u of the impulse or of a speed.
///
/// `mass` and `velocity` are those of the body before the impulse; an impulse of exactly zero changes
/// nothing.
template <typename Scalar, int D>
void require_normal_impulse(const Scene& scene, int i, const Vector<Scalar, D>& dp, const Scalar& mass,
                            const Vector<Scalar, D>& velocity) {
  if (!is_finite(mass) || dp == Vector<Scalar, D>::Zero()) return;
  const Scalar least = (std::numeric_limits<Scalar>::min)();
  const Scalar impulse = dp.cwiseAbs().maxCoeff();
  if (impulse < least) throw OutOfRange("the impulse on " + particle_name(scene, i) + ", which underflows,");
  if (Scalar(impulse / mass) < least && velocity.cwiseAbs().maxCoeff() < least)
    throw OutOfRange("the velocity of " + particle_name(scene, i) + ", which underflows at an impulse,");
}

/// Throws OutOfRange unless every sum of the ledger is finite.
template <typename Scalar, int D>
void require_range(const Ledger<Scalar, D>& ledger) {
  const auto require = [](const Scalar& x, const char* name) {
    if (!is_finite(x)) throw OutOfRange(name);
  };
  require(ledger.kinetic_at_start, "the kinetic energy at the start");
  require(ledger.lost.value(), "the energy lost in collisions");
  require(ledger.stored.value(), "the energy stored in groups");
  require(ledger.work.value(), "the work of impulses from outside");
  require(ledger.kinetic_at_start + ledger.work.value() - ledger.lost.value(), "the kinetic energy");
  require(ledger.energy_bound, "the square of a speed times a mass");
  require(ledger.momentum_bound, "a speed times a mass");
  for (std::size_t k = 0; k < ledger.from_walls.size(); ++k) {
    require(ledger.momentum_at_start[static_cast<int>(k)], "the momentum at the start");
    require(ledger.from_walls[k].value(), "the momentum given by infinite masses");
    require(ledger.from_outside[k].value(), "the momentum given by impulses from outside");
  }
}

}  // namespace tps
