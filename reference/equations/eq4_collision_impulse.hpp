// Eq. (4): the impulse of a rebound and of a retraction (docs/eq4.md).
#pragma once

#include <type_traits>

#include "reference/equations/collision_frame.hpp"
#include "reference/equations/vector.hpp"

namespace tps {

/// Impulse with restitution, eq. (4), in a given frame: Δp = (1 + c) μ v_û.
template <typename Scalar, int D>
Vector<Scalar, D> collision_impulse(const CollisionFrame<Scalar, D>& frame,
                                    const std::type_identity_t<Scalar>& m_A,
                                    const std::type_identity_t<Scalar>& m_B,
                                    const std::type_identity_t<Scalar>& c) {
  return (Scalar(1) + c) * reduced_mass<Scalar>(m_A, m_B) * frame.v_u;
}

/// Impulse with restitution, eq. (4): Δp = (1 + c) (1/m_A + 1/m_B)⁻¹ v_û, to be applied by eq. (3).
///
/// Used with c = c_rebound when two approaching particles block each other, and with c = c_retract when
/// two separating tethered particles are pulled back; the sign of v_n makes the difference.
/// @param c coefficient of restitution in [0, 1]. REQUIRES u_A ≠ u_B, not both masses infinite, 1/m finite.
/// @return Δp, a momentum along û.
/// Laws: (1) afterwards v_n' = −c v_n and v_ŵ' = v_ŵ; (2) momentum is conserved; (3) the kinetic energy
/// falls by ½ μ (1 − c²) v_n²; (4) angular momentum is conserved (Δp is along û); (5) lengths times 2^k
/// change nothing, velocities or masses times 2^k multiply Δp by 2^k, bitwise.
template <typename Scalar, int D>
Vector<Scalar, D> collision_impulse(const Vector<Scalar, D>& u_A, const Vector<Scalar, D>& u_B,
                                    const Vector<Scalar, D>& v_A, const Vector<Scalar, D>& v_B,
                                    const std::type_identity_t<Scalar>& m_A,
                                    const std::type_identity_t<Scalar>& m_B,
                                    const std::type_identity_t<Scalar>& c) {
  return collision_impulse<Scalar, D>(collision_frame<Scalar, D>(u_A, u_B, v_A, v_B), m_A, m_B, c);
}

}  // namespace tps
