// The presynaptic terminal of the paper's Figure 1.
#pragma once

#include <cstdint>

#include "verify/scenes/builder.hpp"

namespace tps {

/// Lengths are in radii of a synapsin, masses in masses of a synapsin, and a synapsin's thermal speed is
/// √temperature in each direction.
struct TerminalParams {
  int vesicles = 48;
  int pairs = 96;
  double membrane_radius = 22;
  double vesicle_radius = 3;
  double vesicle_mass = 8;
  double tether_ratio = 1.3;
  double pair_tether = 4;
  double temperature = 1;
  double c_rebound = 0.98;
  double c_retract = 0.95;
  double c_revolve = 0.9;
  double theta = 30;
  double form_probability = 1;
  double break_probability = 0;
  double impact = 80;
  double impact_at = 50;
  int impacts = 3;
  double grouped = 1e-4;
  double duration = 80;
  std::uint64_t seed = 1;
};

/// Vesicles and pairs of synapsins inside a rigid spherical membrane, at random places without overlap, in
/// Maxwell motion without total momentum.
///
/// The membrane is one particle of infinite mass with a permanent tether (containment) to all others. The two
/// synapsins of a pair are tethered from the start; nothing else is. A vesicle and a synapsin become tethered
/// where they collide. A synapsin has room for two tethers, its mate's and one vesicle's, so a pair bridges
/// at most two vesicles, and whatever cluster of vesicles exists later has formed during the run.
///
/// At the defaults 10 % of the membrane is filled, and the first clusters of three vesicles exist by t = 16,
/// most of them by t = 40. Pairs decide how far clusters grow (80: several small ones, 128: one that holds
/// most vesicles), a long pair_tether lets a bound pair reach a second vesicle before both mates sit on the
/// first, and restitution below 1 cools the motion, so that clusters calm down before the impacts.
///
/// The impacts are impulses `impact` along +x on vesicles 1, 2, … (ids from 1), the first at `impact_at`, the
/// others following evenly until the end. They change the speed of a vesicle by 10, some ten times what is
/// left of its thermal motion by then, so that the reaction of a cluster stands out of its agitation.
///
/// Throws std::invalid_argument when limits contradict each other or the particles do not fit.
Scene build_terminal(const TerminalParams& params);
SceneBuilder terminal_builder();

}  // namespace tps
