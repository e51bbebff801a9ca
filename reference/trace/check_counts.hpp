// Whether what a state says to have counted and added up can be so: of events, of energy, of effects.
#pragma once

#include <vector>

#include "reference/trace/check_state.hpp"

namespace tps {

/// Problems of `progress`, `counts`, `quantities` and `observations`.
std::vector<StateProblem> count_problems(const Scene& scene, const StateData& state, StateOf whose);

}  // namespace tps
