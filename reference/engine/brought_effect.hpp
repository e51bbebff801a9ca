// Effects that a program brings along, beside those of reference/engine/effects/. The library is not changed
// and not built again: `const tps::BringEffect<effects::turns, double> kTurns;` in a source of the program.
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "reference/engine/effect.hpp"
#include "reference/engine/effect_records.hpp"
#include "reference/scene/scene_key.hpp"
#include "reference/text/input_error.hpp"

namespace tps {

/// An effect without its scalars. As those of the catalogue, it is described by a struct E with
/// E::call(scene), E::make<Scalar, D>(scene), and where it has them E::records(scene) and E::key().
struct BroughtEffect {
  EffectCall (*call)(const Scene&);
  EffectRecords (*records)(const Scene&);
  std::optional<SceneKey> key;
};

/// In the order of their constructors. To be filled before main() begins.
std::vector<BroughtEffect>& brought_effects();

template <typename E>
EffectRecords records_of(const Scene& scene) {
  if constexpr (requires { E::records(scene); }) {
    return E::records(scene);
  } else {
    return {};
  }
}

/// How the effects brought along are made in one scalar; null for those that are not there in it.
template <typename Scalar, int D>
using EffectMaker = std::unique_ptr<Effect<Scalar, D>> (*)(const Scene&);

template <typename Scalar, int D>
std::vector<EffectMaker<Scalar, D>>& brought_makers() {
  static std::vector<EffectMaker<Scalar, D>> makers;
  return makers;
}

/// Those that the scene calls for. Throws InputError where one is not there in the scalar.
template <typename Scalar, int D>
void add_brought_effects(std::vector<std::unique_ptr<Effect<Scalar, D>>>& called, const Scene& scene) {
  const std::vector<EffectMaker<Scalar, D>>& makers = brought_makers<Scalar, D>();
  for (std::size_t n = 0; n < brought_effects().size(); ++n) {
    const EffectCall call = brought_effects()[n].call(scene);
    if (call.because.empty()) continue;
    if (n >= makers.size() || makers[n] == nullptr)
      throw InputError({{"", 0, "",
                         "the scene calls for " + call.name + " by " + call.because.front().what +
                             ", which this program has in other scalars or dimensions only; choose one of "
                             "them, as by --scalar double"}});
    called.push_back(makers[n](scene));
  }
}

template <typename E, typename... Scalars>
class BringEffect {
 public:
  BringEffect() {
    std::optional<SceneKey> key;
    if constexpr (requires { E::key(); }) key = E::key();
    brought_effects().push_back({&E::call, &records_of<E>, key});
    (bring<Scalars>(), ...);
  }

 private:
  template <typename Scalar>
  static void bring() {
    at_its_place(brought_makers<Scalar, 2>()) = &E::template make<Scalar, 2>;
    at_its_place(brought_makers<Scalar, 3>()) = &E::template make<Scalar, 3>;
  }
  template <typename Maker>
  static Maker& at_its_place(std::vector<Maker>& makers) {
    makers.resize(brought_effects().size(), nullptr);
    return makers.back();
  }
};

}  // namespace tps
