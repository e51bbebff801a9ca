#include <fmt/format.h>

#include <cmath>

#include "reference/scene/check_scene.hpp"
#include "reference/text/number_text.hpp"
#include "reference/text/schema_words.hpp"

namespace tps {
namespace {

const Species& of(const Scene& scene, int species) {
  return scene.species[static_cast<std::size_t>(species)];
}

void check_pair_with_friction(const Scene& scene, const PairLaw& law, const std::string& at,
                              SceneSource& source) {
  if (!law.blocking) {
    source.report(at,
                  "\"friction\" acts at rebounds, and the pair has no \"blocking\"; give it one, or remove "
                  "\"friction\"");
    return;
  }
  const Species& a = of(scene, law.species_a);
  const Species& b = of(scene, law.species_b);
  for (const Species* species : {&a, &b}) {
    if (std::isfinite(species->mass) && !(species->radius > 0))
      source.report(
          at,
          fmt::format("{} has radius 0, and no moment of inertia; \"friction\" turns particles: give it a "
                      "radius, or remove \"friction\"",
                      in_quotes(species->name)));
  }
  const double sum = a.radius + b.radius;
  if (law.blocking->distance != sum)
    source.report(
        at,
        fmt::format("\"friction\" acts where surfaces touch, at the sum of the radii, {}, but the blocking "
                    "distance is {}; leave \"distance\" out, or change the radii",
                    write_shortest(sum), write_shortest(law.blocking->distance)));
}

}  // namespace

void check_friction(const Scene& scene, SceneSource& source) {
  bool called = false;
  for (std::size_t k = 0; k < scene.pairs.size(); ++k) {
    if (!scene.pairs[k].friction) continue;
    called = true;
    check_pair_with_friction(scene, scene.pairs[k], fmt::format("/pairs/{}/friction", k), source);
    if (scene.grouping)
      source.report(fmt::format("/pairs/{}/friction", k),
                    "\"friction\" and \"grouping\" are not defined together: a grouped body moves without "
                    "turning, so that nothing says what friction does to its spin; remove one of the two");
    if (scene.drag)
      source.report(
          fmt::format("/pairs/{}/friction", k),
          "\"friction\" and \"drag\" are not defined together: dv/dt = -gamma v does not say how the "
          "fluid slows spins; remove one of the two");
  }
  for (std::size_t k = 0; k < source.particle_entries.size(); ++k) {
    const Particle& particle = scene.particles[k];
    if (spin_of(scene, k) == Coordinates{} || keeps_spin(scene, particle.species)) continue;
    source.report(fmt::format("/particles/{}/spin", source.particle_entries[k]),
                  fmt::format("particle {} keeps no spin: {} {}; remove \"spin\"", particle.id,
                              in_quotes(of(scene, particle.species).name),
                              called && !std::isfinite(of(scene, particle.species).mass)
                                  ? "has infinite mass and does not turn"
                                  : "is in no pair with \"friction\""));
  }
}

}  // namespace tps
