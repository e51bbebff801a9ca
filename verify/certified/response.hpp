// Eqs. (4), (5), (6) and (7) on real numbers, with inverse masses, so that an infinite mass is a zero. Heavy
// header: only sources of this folder include it.
#pragma once

#include "verify/certified/real.hpp"

namespace tps::certified {

/// 1/m; 1/∞ = 0.
Real inverse_mass(double mass);

/// Two bodies at a limit, seen from A. REQUIRES u_A ≠ u_B, not both inverse masses zero.
struct Collision {
  RealVector r;  ///< u_B − u_A
  RealVector v;  ///< v_AB
  Real mu;       ///< reduced mass
  Real rr, vr;   ///< r·r and v·r = |r| v_n
  RealVector w;  ///< v_ŵ = v − (v·r) r / (r·r): rational where the input is
};
Collision collision(RealVector r, RealVector v, const Real& inverse_A, const Real& inverse_B);

/// Eq. (4) without û, which is a root: Δp = (1 + c) μ (v·r) r / (r·r).
RealVector collision_impulse(const Collision& pair, double c);

/// Eq. (5): Δp = μ (v − v'), v' = c^(θ/π) |v| (cos θ ŵ − sin θ û). REQUIRES sign(v_ŵ²) positive.
RealVector revolution_impulse(const Collision& pair, double c_revolve, double theta_deg);

/// Which of the two a tethered pair does: |c_retract v_n| > tan θ |v_ŵ| or v_ŵ = 0 retracts.
struct TetherDecision {
  bool retracts;
  bool boundary;  ///< equality, or not told from it at the working precision
};
TetherDecision tether_decision(const Collision& pair, double c_retract, double theta_deg);

/// Eq. (6): the weight of A is 1 / (1 + m_B/m_A).
RealVector load_velocity(const Real& inverse_A, const Real& inverse_B, const RealVector& v_A,
                         const RealVector& v_B);

}  // namespace tps::certified
