// A collision as its trace tells it, and what the equations make of it: the judge's own derivation, in angles
// and components, not in the reference's steps.
#pragma once

#include <optional>
#include <string>

#include "properties/runs/implied_state.hpp"

namespace tps::properties::runs {

/// Two bodies at an event, seen from the body of i.
struct Collided {
  int i, j;
  Real mass_i, mass_j, mu;  ///< of the bodies
  Point v_i, v_j, v_AB, axis;
  Real distance;
  Real v_n;        ///< along the axis: negative while approaching
  Point v_across;  ///< the rest
};

/// REQUIRES an event of two particles. At a restitution the masses are those of its node.
Collided collided(const ImpliedState& before, const TracedEvent& event);

/// Eq. (6): (m_i v_i + m_j v_j) / (m_i + m_j); the velocity of an infinite mass.
Point load_velocity(const Collided& c);

/// ½ μ (1 − c²) v_n² by eq. (4), ½ μ (1 − c_revolve^(2θ/π)) |v_AB|² by eq. (5); zero where the event stood
/// with Δp = 0.
Real energy_lost(const ImpliedState& before, const Collided& c, const TracedEvent& event);

/// By how much directed rounding (D22) may change the velocity of the lighter body at an event that parts two
/// bodies (docs/engine.md): √D times what v_n' may be wrong by, 54 u of the speeds before and after and, at a
/// restitution, of those before the load, where Δp_AB was rounded, and the turn of the axis. Nothing where
/// v_n' by eq. (3) is larger than that, since its sign is then right.
Real directed_change(const ImpliedState& before, const TracedEvent& event, Real u);

/// |Δp| of the tether's response, were it not broken.
Real tether_impulse(const ImpliedState& before, const Collided& c);

/// What is wrong with the impulse of a collision, to the roundings that docs/ledger.md counts; nothing where
/// it is right.
std::optional<std::string> wrong_impulse(const ImpliedState& before, const Collided& c,
                                         const TracedEvent& event, Real u);

}  // namespace tps::properties::runs
