// Eq. (1): how far apart two particles are after a time of free flight (docs/eq1.md).
#pragma once

#include <type_traits>

#include "reference/equations/vector.hpp"

namespace tps {

/// Distance of two particles after free flight, eq. (1):
///   Δu(Δt) = |(u_B + v_B Δt) − (u_A + v_A Δt)|.
///
/// @param u_A,u_B positions; @param v_A,v_B velocities; @param dt time of flight Δt, of either sign.
/// @return Δu ≥ 0, in units of length.
/// Laws: (1) distance_after(A, B, dt) == distance_after(B, A, dt) bitwise; (2) at dt = 0 it is |u_B − u_A|;
/// (3) equal velocities keep it constant, to the rounding of u + v Δt.
template <typename Scalar, int D>
Scalar distance_after(const Vector<Scalar, D>& u_A, const Vector<Scalar, D>& u_B,
                      const Vector<Scalar, D>& v_A, const Vector<Scalar, D>& v_B,
                      const std::type_identity_t<Scalar>& dt) {
  const Vector<Scalar, D> separation = (u_B + v_B * dt) - (u_A + v_A * dt);
  return norm<Scalar, D>(separation);
}

}  // namespace tps
