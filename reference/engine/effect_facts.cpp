#include "reference/engine/effect_facts.hpp"

#include "reference/engine/effect_catalogue.hpp"
#include "reference/scene/scene_key.hpp"

namespace tps {

std::vector<BroughtEffect>& brought_effects() {
  static std::vector<BroughtEffect> brought;
  return brought;
}

std::vector<EffectFacts> effect_facts(const Scene& scene) {
  std::vector<EffectFacts> facts;
  const auto add = [&](const EffectCall& call, EffectRecords records) {
    facts.push_back({call.name, !call.because.empty(), std::move(records)});
  };
  visit_effects([&]<typename E>(E) { add(E::call(scene), records_of<E>(scene)); });
  for (const BroughtEffect& brought : brought_effects()) add(brought.call(scene), brought.records(scene));
  return facts;
}

const std::vector<KindOfEffect>& event_kinds() {
  static const std::vector<KindOfEffect> kinds = [] {
    std::vector<KindOfEffect> all;
    for (const EffectFacts& facts : effect_facts(Scene{})) {
      for (const EventKind& kind : facts.records.kinds) all.push_back({kind, facts.name});
    }
    return all;
  }();
  return kinds;
}

const std::vector<SceneKey>& scene_keys() {
  static const std::vector<SceneKey> keys = [] {
    std::vector<SceneKey> all;
    visit_effects([&]<typename E>(E) {
      if constexpr (requires { E::key(); }) all.push_back(E::key());
    });
    for (const BroughtEffect& brought : brought_effects()) {
      if (brought.key) all.push_back(*brought.key);
    }
    return all;
  }();
  return keys;
}

}  // namespace tps
