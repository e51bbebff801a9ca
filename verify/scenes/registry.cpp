#include "verify/scenes/registry.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "verify/scenes/action_potential.hpp"
#include "verify/scenes/brownian.hpp"
#include "verify/scenes/chain.hpp"
#include "verify/scenes/cradle.hpp"
#include "verify/scenes/galperin.hpp"
#include "verify/scenes/gas.hpp"
#include "verify/scenes/granular.hpp"
#include "verify/scenes/pair.hpp"
#include "verify/scenes/ring.hpp"
#include "verify/scenes/rough.hpp"
#include "verify/scenes/sediment.hpp"
#include "verify/scenes/sheet.hpp"
#include "verify/scenes/terminal.hpp"
#include "verify/scenes/three_body.hpp"
#include "verify/scenes/two_anchors.hpp"

namespace tps {

const std::vector<SceneBuilder>& scene_builders() {
  static const std::vector<SceneBuilder> builders{
      terminal_builder(),   action_potential_builder(), chain_builder(), sheet_builder(),
      three_body_builder(), galperin_builder(),         gas_builder(),   pair_builder(),
      cradle_builder(),     two_anchors_builder(),      ring_builder(),  brownian_builder(),
      sediment_builder(),   granular_builder(),         rough_builder(),
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
