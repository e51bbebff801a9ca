// Eq. (7): the impulse that is kept while two bodies are grouped, until they part (docs/eq7.md).
#pragma once

#include <type_traits>

#include "reference/equations/collision_frame.hpp"
#include "reference/equations/vector.hpp"

namespace tps {

/// Impulse recorded at a load and applied by eq. (3) at the restitution, eq. (7): Δp_AB = Δp − μ v_AB.
///
/// @param dp the impulse of eq. (4) or (5). @param v_A,v_B velocities before the load.
/// Laws: (1) eqs. (6) then (7) with (3) give the same velocities as (3) with Δp alone; (2) the energy kept
/// meanwhile is |Δp_AB|² / 2μ; (3) exchanging A and B flips Δp_AB, bitwise.
template <typename Scalar, int D>
Vector<Scalar, D> restitution_impulse(const std::type_identity_t<Scalar>& m_A,
                                      const std::type_identity_t<Scalar>& m_B, const Vector<Scalar, D>& v_A,
                                      const Vector<Scalar, D>& v_B, const Vector<Scalar, D>& dp) {
  const Vector<Scalar, D> v_AB = v_B - v_A;
  return dp - reduced_mass<Scalar>(m_A, m_B) * v_AB;
}

}  // namespace tps
