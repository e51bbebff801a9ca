// What `tps explain` says of an effect. Apart from effect.hpp, so that saying it needs no engine.
#pragma once

#include <string>
#include <vector>

namespace tps {

/// Whether a scene calls for an effect, for people: `tps explain`.
struct EffectCall {
  std::string name;
  std::string what;                  ///< in a few words, with its equations
  std::vector<std::string> because;  ///< places of the scene that call for it; empty: not simulated
  std::string called_by;             ///< what in a scene would call for it
  std::string cost;                  ///< what it adds to the run, in particles, pairs, events
};

}  // namespace tps
