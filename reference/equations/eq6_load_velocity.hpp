// Eq. (6): the common velocity of two bodies that are grouped (docs/eq6.md).
#pragma once

#include <type_traits>

#include "reference/equations/vector.hpp"

namespace tps {

/// Common velocity of two bodies while they are loaded, eq. (6):
///   v_load = (1 + m_B/m_A)⁻¹ v_A + (1 + m_A/m_B)⁻¹ v_B.
///
/// The ratios let an infinite mass through without a special case: its weight is 1, the other's 0.
/// @param m_A,m_B masses in (0, ∞]. REQUIRES not both infinite.
/// Laws: (1) (m_A + m_B) v_load = m_A v_A + m_B v_B; (2) each component of v_load is
/// between those of v_A and v_B, to rounding; (3) A and B may be exchanged; (4) with an infinite mass v_load
/// is its velocity. (3) and (4) bitwise, but for the sign of a zero.
template <typename Scalar, int D>
Vector<Scalar, D> load_velocity(const std::type_identity_t<Scalar>& m_A,
                                const std::type_identity_t<Scalar>& m_B, const Vector<Scalar, D>& v_A,
                                const Vector<Scalar, D>& v_B) {
  const Scalar weight_A = Scalar(1) / (Scalar(1) + m_B / m_A);
  const Scalar weight_B = Scalar(1) / (Scalar(1) + m_A / m_B);
  return weight_A * v_A + weight_B * v_B;
}

}  // namespace tps
