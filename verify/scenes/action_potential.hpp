// The presynaptic terminal of the paper's Figure 1 while an action potential passes.
#pragma once

#include "verify/scenes/terminal.hpp"

namespace tps {

/// Units as in TerminalParams.
struct ActionPotentialParams {
  int vesicles = 48;
  int pairs = 96;
  double membrane_radius = 22;
  double temperature = 1;
  double form_probability = 1;
  double potential_at = 45;
  double potential_for = 10;
  double grouped = 1e-4;
  double duration = 120;
  std::uint64_t seed = 1;
};

/// The terminal without impacts, and a phase: while the action potential lasts, a tether of a vesicle and a
/// synapsin breaks at its first pull and none forms, so that clusters fall apart; afterwards they form again,
/// more slowly, since pulls have cost motion meanwhile. At the defaults 37 of 48 vesicles are in clusters of
/// three or more at t = 42, none at t = 54 and t = 60, and 27 at t = 120.
///
/// Throws std::invalid_argument as build_terminal does.
Scene build_action_potential(const ActionPotentialParams& params);
SceneBuilder action_potential_builder();

}  // namespace tps
