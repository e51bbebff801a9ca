// The quantities that the paper defines ahead of eqs. (4), (5) and (7): the axis of a collision and the
// relative velocity along and across it; and the mass that every impulse formula contains (docs/eq4.md).
#pragma once

#include <type_traits>

#include "reference/equations/vector.hpp"

namespace tps {

/// Reduced mass μ = (1/m_A + 1/m_B)⁻¹ of eqs. (4), (5) and (7).
///
/// Masses are in (0, ∞]; with one of them infinite it is the other, to two roundings (1/(1/49) is not 49 in
/// double). REQUIRES not both infinite, and 1/m finite (a double mass of at least 5.6e−309).
/// Law: reduced_mass(m_A, m_B) == reduced_mass(m_B, m_A) bitwise.
template <typename Scalar>
Scalar reduced_mass(const Scalar& m_A, const std::type_identity_t<Scalar>& m_B) {
  return Scalar(1) / (Scalar(1) / m_A + Scalar(1) / m_B);
}

/// A collision seen from A: everything that eqs. (4) and (5) are made of.
template <typename Scalar, int D>
struct CollisionFrame {
  Vector<Scalar, D> u_hat;  ///< û, unit vector from A to B
  Vector<Scalar, D> v_AB;   ///< velocity of B relative to A
  Scalar v_n;               ///< v_AB·û: negative while approaching
  Vector<Scalar, D> v_u;    ///< v_û = v_n û, the normal part
  Vector<Scalar, D> v_w;    ///< v_ŵ = v_AB − v_û, the tangential part
};

/// Axis and relative velocity of a colliding pair.
///
/// Departs from the paper's notation: it calls both the number v_n and the vector v_n û by the one name
/// v_û. v_ŵ is a difference: where the motion is nearly along û its relative error is that of rounding times
/// |v_AB|/|v_ŵ|. What it then has along û is taken off once more, and where that is most of it there was
/// nothing but rounding, and v_ŵ = 0 (Kahan and Parlett, "twice is enough"): eq. (5) turns the pair from v_ŵ,
/// and would let a head-on pair go outwards along whatever rounding left. REQUIRES u_A ≠ u_B. Law: swapping A
/// and B flips û and v_AB, keeps v_n, and flips v_û and v_ŵ, bitwise.
template <typename Scalar, int D>
CollisionFrame<Scalar, D> collision_frame(const Vector<Scalar, D>& u_A, const Vector<Scalar, D>& u_B,
                                          const Vector<Scalar, D>& v_A, const Vector<Scalar, D>& v_B) {
  const Vector<Scalar, D> u_hat = unit_vector<Scalar, D>(u_B - u_A);
  const Vector<Scalar, D> v_AB = v_B - v_A;
  const Scalar v_n = v_AB.dot(u_hat);
  const Vector<Scalar, D> v_u = v_n * u_hat;
  const Vector<Scalar, D> rest = v_AB - v_u;
  const Vector<Scalar, D> across = rest - rest.dot(u_hat) * u_hat;
  const bool only_rounding = across.squaredNorm() < rest.squaredNorm() / Scalar(4);
  const Vector<Scalar, D> v_w = only_rounding ? Vector<Scalar, D>(Vector<Scalar, D>::Zero()) : across;
  return {u_hat, v_AB, v_n, v_u, v_w};
}

}  // namespace tps
