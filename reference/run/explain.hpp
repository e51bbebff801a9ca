// What a scene asks for, before it is run.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "reference/engine/effect_call.hpp"
#include "reference/scene/scene.hpp"

namespace tps {

struct SceneExplanation {
  struct Count {
    std::string name;
    std::uint64_t count;
  };
  std::string title;
  int dimension = 0;
  std::uint64_t particles = 0;
  std::uint64_t all_pairs = 0;
  std::uint64_t interacting_pairs = 0;
  std::vector<Count> species;
  std::vector<EffectCall> effects;  ///< every effect there is; those without a reason are not simulated
};

SceneExplanation explain(const Scene& scene);

}  // namespace tps
