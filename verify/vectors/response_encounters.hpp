// Two particles that meet, drawn near what a response decides by: what the strata of responses ask of.
#pragma once

#include <vector>

#include "verify/vectors/stratum.hpp"

namespace tps::vectors::encounters {

/// Every number that some response asks for.
struct Encounter {
  std::vector<double> u_A, u_B, v_A, v_B, dp;
  double m_A, m_B, c, c_retract, c_revolve, theta_revolve_deg;
};

Encounter plain(Random& random, int dimension);
/// Ratios up to 1e30, and walls.
Encounter masses(Random& random, int dimension);
/// Restitution 0 or 1 and the ends of the range of θ_revolve.
Encounter coefficients(Random& random, int dimension);
/// Small integers, masses that are powers of two, coefficients that are multiples of 1/4: many answers are
/// exact.
Encounter integers(Random& random, int dimension);
/// r and v almost perpendicular: v_n is what cancels.
Encounter perpendicular(Random& random, int dimension);
/// The velocities differ by one unit in the last place.
Encounter near_static(Random& random, int dimension);
Encounter offset_origin(Random& random, int dimension);
Encounter any_scale(Random& random, int dimension);
Encounter float32(Random& random, int dimension);
/// |c_retract v_n| = tan θ |v_ŵ| exactly: θ = 45°, along an axis, or v_ŵ = 0 with c_retract = 0.
Encounter boundary(Random& random, int dimension);
/// The boundary with one number changed in its last bit.
Encounter near_boundary(Random& random, int dimension);
/// |c_retract v_n| and tan θ |v_ŵ| differ by 2^-k of themselves, along any axis: θ where tan θ has a root at
/// most, since a library's tangent is its own in the last bit.
Encounter graded_boundary(Random& random, int dimension);
/// Almost elastic: what is lost is 2^-k of what comes back.
Encounter near_elastic(Random& random, int dimension);
/// Hardly any restitution: what comes back is 2^-k of what came.
Encounter near_plastic(Random& random, int dimension);
/// An angle beside one whose sine or tangent everybody knows, by 2^-k of it.
Encounter graded_angle(Random& random, int dimension);
/// All but equal: the masses differ by 2^-k of themselves.
Encounter graded_masses(Random& random, int dimension);
/// In units in which both masses, and what is passed on with them, are very small or large.
Encounter any_mass(Random& random, int dimension);
/// Every component times a 2^-k of its own.
Encounter spread(Random& random, int dimension);
/// Nothing comes back along r, and across it the velocity is 2^-k of that along it: a revolution still.
Encounter graded_across(Random& random, int dimension);

}  // namespace tps::vectors::encounters
