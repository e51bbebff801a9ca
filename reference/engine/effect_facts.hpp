// The effects there are, for whoever reads and judges what they left: no engine, no scalar.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "reference/engine/effect_records.hpp"

namespace tps {

struct EffectFacts {
  std::string name;
  bool called;  ///< by the scene
  EffectRecords records;
};

/// Of every effect of the catalogue, in its order, and of those that the program brings along.
std::vector<EffectFacts> effect_facts(const Scene& scene);

struct KindOfEffect {
  EventKind kind;
  std::string effect;
};
/// Every kind of event that some effect records, in the order of effect_facts.
const std::vector<KindOfEffect>& event_kinds();

}  // namespace tps
