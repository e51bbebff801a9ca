#include "verify/scenes/thermal.hpp"

#include <cmath>

namespace tps {

Coordinates random_direction(RandomStream& stream) {
  while (true) {
    Coordinates point{};
    for (double& x : point) x = 2 * next_uniform(stream) - 1;
    const double square = point[0] * point[0] + point[1] * point[1] + point[2] * point[2];
    if (square > 1 || square < 0x1p-20) continue;  // so near the centre the direction would be coarse
    const double length = std::sqrt(square);
    for (double& x : point) x /= length;
    return point;
  }
}

Scene with_thermal_velocities(Scene scene, double temperature) {
  const auto dimension = static_cast<std::size_t>(scene.dimension);
  const auto mass_of = [&](const Particle& particle) {
    return scene.species[static_cast<std::size_t>(particle.species)].mass;
  };
  Coordinates momentum{};
  double total_mass = 0;
  for (Particle& particle : scene.particles) {
    const double mass = mass_of(particle);
    if (std::isinf(mass)) continue;
    RandomStream stream{scene.seed, Purpose::scene_velocity, static_cast<std::uint32_t>(particle.id), 0, 0};
    for (std::size_t k = 0; k < dimension; ++k) {
      particle.velocity[k] = std::sqrt(temperature / mass) * next_normal(stream);
      momentum[k] += mass * particle.velocity[k];
    }
    total_mass += mass;
  }
  for (Particle& particle : scene.particles) {
    if (std::isinf(mass_of(particle))) continue;
    for (std::size_t k = 0; k < dimension; ++k) particle.velocity[k] -= momentum[k] / total_mass;
  }
  return scene;
}

}  // namespace tps
