#include "reference/scene/random_kicks.hpp"

#include <cmath>

namespace tps {
namespace {

const Species& species_of(const Scene& scene, const Particle& particle) {
  return scene.species[static_cast<std::size_t>(particle.species)];
}

RandomStream stream_of(std::uint64_t seed, Purpose purpose, std::int32_t id, std::uint32_t n) {
  return {seed, purpose, static_cast<std::uint32_t>(id), n, 0};
}

/// Normal numbers in the components that the scene has.
Coordinates normal_vector(RandomStream& stream, int dimension) {
  Coordinates x{};
  for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k) x[k] = next_normal(stream);
  return x;
}

double length(const Coordinates& x) {
  return std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
}

}  // namespace

PoissonTimes::PoissonTimes(std::uint64_t seed, Purpose purpose, std::int32_t id, double tau)
    : seed_(seed), purpose_(purpose), id_(static_cast<std::uint32_t>(id)), tau_(tau) {
  add_wait(1);
}

void PoissonTimes::advance() {
  add_wait(++done_ + 1);
}

void PoissonTimes::add_wait(std::uint32_t n) {
  RandomStream stream{seed_, purpose_, id_, n, 0};
  sum_ += next_exponential(stream);
}

Coordinates random_impulse(const Scene& scene, const Particle& particle, std::uint32_t n) {
  const RandomImpulses& law = species_of(scene, particle).random_impulses.value();
  RandomStream stream = stream_of(scene.seed, Purpose::random_impulse, particle.id, n);
  const double magnitude = next_gamma(stream, law.shape) * (law.mean / law.shape);
  Coordinates J = normal_vector(stream, scene.dimension);
  while (length(J) == 0) J = normal_vector(stream, scene.dimension);
  const double share = magnitude / length(J);
  for (double& x : J) x *= share;
  return J;
}

namespace {

/// √(x/y), also where the quotient is no normal number: then x is taken by an even power of two nearer to y.
double root_of_quotient(double x, double y) {
  const double quotient = x / y;
  if (std::isnormal(quotient)) return std::sqrt(quotient);
  constexpr int kHalf = 250;
  const int half = quotient > 1 ? -kHalf : kHalf;
  return std::ldexp(std::sqrt(std::ldexp(x, 2 * half) / y), -half);
}

}  // namespace

Coordinates maxwell_velocity(const Scene& scene, const Particle& particle, std::uint32_t n) {
  const Species& species = species_of(scene, particle);
  RandomStream stream = stream_of(scene.seed, Purpose::thermostat, particle.id, n);
  const double deviation = root_of_quotient(species.thermostat.value().kT, species.mass);
  Coordinates v = normal_vector(stream, scene.dimension);
  for (double& x : v) x *= deviation;
  return v;
}

}  // namespace tps
