// What `tps explain` says of an effect. Apart from effect.hpp, so that saying it needs no engine.
#pragma once

#include <string>
#include <vector>

namespace tps {

/// A place of a scene that calls for an effect.
struct CallingPlace {
  std::string what;     ///< for people
  std::string pointer;  ///< JSON pointer from the scene
};

/// Whether a scene calls for an effect, for people: `tps explain`.
struct EffectCall {
  std::string name;
  std::string what;                   ///< in a few words, with its equations
  std::vector<CallingPlace> because;  ///< what of the scene calls for it; empty: not simulated
  std::string called_by;              ///< what in a scene would call for it
  std::string cost;                   ///< what it adds to the run, in particles, pairs, events
};

}  // namespace tps
