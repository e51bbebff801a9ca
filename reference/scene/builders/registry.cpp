#include "reference/scene/builders/registry.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "reference/scene/builders/chain.hpp"
#include "reference/scene/builders/cradle.hpp"
#include "reference/scene/builders/galperin.hpp"
#include "reference/scene/builders/gas.hpp"
#include "reference/scene/builders/pair.hpp"
#include "reference/scene/builders/ring.hpp"
#include "reference/scene/builders/sheet.hpp"
#include "reference/scene/builders/terminal.hpp"
#include "reference/scene/builders/three_body.hpp"
#include "reference/scene/builders/two_anchors.hpp"

namespace tps {

const std::vector<SceneBuilder>& scene_builders() {
  static const std::vector<SceneBuilder> builders{
      terminal_builder(), chain_builder(), sheet_builder(),  three_body_builder(),  galperin_builder(),
      gas_builder(),      pair_builder(),  cradle_builder(), two_anchors_builder(), ring_builder(),
  };
  return builders;
}

const SceneBuilder& scene_builder(const std::string& name) {
  std::string names;
  for (const SceneBuilder& builder : scene_builders()) {
    if (builder.name == name) return builder;
    names += " " + builder.name;
  }
  throw std::invalid_argument(fmt::format("no scene is called \"{}\"; there are:{}", name, names));
}

}  // namespace tps
