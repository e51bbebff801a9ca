// Eq. (3): what an impulse does to the velocities of a pair (docs/eq3.md).
#pragma once

#include <type_traits>

#include "reference/equations/vector.hpp"

namespace tps {

/// Velocities of a pair of bodies.
template <typename Scalar, int D>
struct PairVelocities {
  Vector<Scalar, D> v_A, v_B;
};

/// New velocities after an impulse, eq. (3): v_A' = v_A + Δp/m_A, v_B' = v_B − Δp/m_B.
///
/// @param m_A,m_B masses in (0, ∞]; dividing by an infinite mass gives zero, so it keeps its velocity.
/// @param dp impulse Δp on A; B receives −Δp.
/// Laws: (1) m_A v_A + m_B v_B is conserved; (2) Δp = 0 changes nothing; (3) an infinite
/// mass keeps its velocity; (4) A and B may be exchanged with −Δp for Δp. (2) to (4) bitwise, but for the
/// sign of a zero.
template <typename Scalar, int D>
PairVelocities<Scalar, D> apply_impulse(const std::type_identity_t<Scalar>& m_A,
                                        const std::type_identity_t<Scalar>& m_B, const Vector<Scalar, D>& v_A,
                                        const Vector<Scalar, D>& v_B, const Vector<Scalar, D>& dp) {
  return {v_A + dp / m_A, v_B - dp / m_B};
}

}  // namespace tps
