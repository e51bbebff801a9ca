// Kicks that particles get at random times, as functions of the scene alone: the n-th one of a particle is a
// function of (seed, purpose, id, n), so that nothing of what else happens, nor a resume, changes it.
#pragma once

#include <cstdint>

#include "reference/scene/random.hpp"
#include "reference/scene/scene.hpp"

namespace tps {

/// The times of a Poisson process: t_n = τ S_n, S_n the sum of n exponential numbers of mean 1, both rounded
/// in double; n = 1, 2, …
class PoissonTimes {
 public:
  PoissonTimes(std::uint64_t seed, Purpose purpose, std::int32_t id, double tau);

  /// t_n of the first n that is not done.
  double next() const { return tau_ * sum_; }
  std::uint32_t done() const { return done_; }
  void advance();

 private:
  void add_wait(std::uint32_t n);

  std::uint64_t seed_;
  Purpose purpose_;
  std::uint32_t id_;
  double tau_;
  std::uint32_t done_ = 0;
  double sum_ = 0;
};

/// The impulse J_n of a particle's species: |J| gamma-distributed, its direction uniform on the sphere (in
/// the plane, the circle). REQUIRES that the species has random impulses.
Coordinates random_impulse(const Scene& scene, const Particle& particle, std::uint32_t n);

/// The velocity that the thermostat gives a particle the n-th time: each component normal with variance kT/m.
/// REQUIRES that the species has a thermostat.
Coordinates maxwell_velocity(const Scene& scene, const Particle& particle, std::uint32_t n);

}  // namespace tps
