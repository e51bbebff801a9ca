#include "reference/run/explain.hpp"

#include "reference/engine/effect_catalogue.hpp"

namespace tps {

SceneExplanation explain(const Scene& scene) {
  SceneExplanation result;
  result.title = scene.title;
  result.dimension = scene.dimension;
  result.particles = scene.particles.size();
  result.all_pairs = result.particles * (result.particles - 1) / 2;
  result.interacting_pairs = interacting_pairs(scene, [](const PairLaw&) { return true; });
  for (const Species& species : scene.species) result.species.push_back({species.name, 0});
  for (const Particle& p : scene.particles) ++result.species[static_cast<std::size_t>(p.species)].count;
  result.effects = effect_calls(scene);
  return result;
}

}  // namespace tps
