#include "reference/scene/read_spins.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "reference/scene/scene_values.hpp"

namespace tps {
namespace {

Coordinates read_spin(const JsonValue::Array& list, int dimension, const std::string& pointer,
                      SceneSource& source) {
  const std::size_t size = dimension == 2 ? 1 : 3;
  Coordinates spin{};
  if (list.size() != size)
    source.report(
        pointer, fmt::format("found {} numbers; allowed: {} in {} dimensions", list.size(), size, dimension));
  for (std::size_t k = 0; k < std::min(size, list.size()); ++k) spin[k] = json_number(list[k]).value();
  return spin;
}

}  // namespace

void read_spins(Scene& scene, SceneSource& source) {
  const JsonValue::Array& list = *source.root().find("particles")->array();
  for (std::size_t n = 0; n < scene.particles.size(); ++n) {
    const std::size_t entry = source.particle_entries[n];
    const JsonValue* spin = list[entry].find("spin");
    if (spin == nullptr) continue;
    set_spin(scene, n,
             read_spin(*spin->array(), scene.dimension, fmt::format("/particles/{}/spin", entry), source));
  }
}

}  // namespace tps
