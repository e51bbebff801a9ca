// Eq. (5): the impulse of a revolution, and when a retraction suffices instead (docs/eq5.md).
#pragma once

#include <cmath>
#include <type_traits>

#include "reference/equations/angle.hpp"
#include "reference/equations/collision_frame.hpp"
#include "reference/equations/vector.hpp"

namespace tps {

/// Whether retraction by eq. (4) draws a pair together at an angle above θ_revolve from perpendicular:
///   |c_retract v_n| > tan θ |v_ŵ|, strictly; or v_ŵ = 0.
///
/// Departs from the paper by the guard v_ŵ = 0: û_revolve would be 0/0, and a pair without tangential motion
/// has nothing to revolve with. On equality rounding decides (semantics §2).
template <typename Scalar, int D>
bool retraction_suffices(const CollisionFrame<Scalar, D>& frame,
                         const std::type_identity_t<Scalar>& c_retract,
                         const std::type_identity_t<Scalar>& tan_theta) {
  using std::abs;
  const Scalar tangential_speed = norm<Scalar, D>(frame.v_w);
  return tangential_speed == Scalar(0) || abs(c_retract * frame.v_n) > tan_theta * tangential_speed;
}

/// A revolution seen from A, with the names of the paper.
template <typename Scalar, int D>
struct Revolution {
  Vector<Scalar, D> v_revolve;      ///< v_ŵ − tan θ |v_ŵ| û
  Vector<Scalar, D> u_hat_revolve;  ///< its unit vector
  Scalar speed_ratio;               ///< c_revolve^(θ/π)
  Vector<Scalar, D> v_AB_after;     ///< v_AB'
};

/// The relative velocity after a revolution: v_AB' = c_revolve^(θ/π) |v_AB| û_revolve.
///
/// The paper prints c_revolve θ/π as a product; its example, four collisions a revolution at 45° with
/// 0.5^(1/4) ≈ 0.84 each, makes it an exponent (docs/decisions.md). θ/π is θ in degrees over 180.
/// REQUIRES v_ŵ ≠ 0.
template <typename Scalar, int D>
Revolution<Scalar, D> revolution(const CollisionFrame<Scalar, D>& frame,
                                 const std::type_identity_t<Scalar>& c_revolve,
                                 const std::type_identity_t<Scalar>& theta_revolve_deg) {
  using std::pow;
  const Scalar tangential_speed = norm<Scalar, D>(frame.v_w);
  const Vector<Scalar, D> v_revolve =
      frame.v_w - (tan_degrees<Scalar>(theta_revolve_deg) * tangential_speed) * frame.u_hat;
  const Vector<Scalar, D> u_hat_revolve = unit_vector<Scalar, D>(v_revolve);
  const Scalar speed_ratio = pow(c_revolve, Scalar(theta_revolve_deg / Scalar(180)));
  const Scalar speed_before = norm<Scalar, D>(frame.v_AB);
  const Vector<Scalar, D> v_AB_after = (speed_ratio * speed_before) * u_hat_revolve;
  return {v_revolve, u_hat_revolve, speed_ratio, v_AB_after};
}

/// Impulse of a revolution, eq. (5), in a given frame: Δp = μ (v_AB − v_AB').
template <typename Scalar, int D>
Vector<Scalar, D> revolution_impulse(const CollisionFrame<Scalar, D>& frame,
                                     const std::type_identity_t<Scalar>& m_A,
                                     const std::type_identity_t<Scalar>& m_B,
                                     const std::type_identity_t<Scalar>& c_revolve,
                                     const std::type_identity_t<Scalar>& theta_revolve_deg) {
  const Revolution<Scalar, D> turned = revolution<Scalar, D>(frame, c_revolve, theta_revolve_deg);
  return reduced_mass<Scalar>(m_A, m_B) * (frame.v_AB - turned.v_AB_after);
}

/// Impulse of a revolution, eq. (5): Δp = (1/m_A + 1/m_B)⁻¹ (v_AB − v_AB'), to be applied by eq. (3).
///
/// @param c_revolve ratio of relative speeds over one whole revolution, in [0, 1].
/// @param theta_revolve_deg θ_revolve in degrees, in [1e−6, 90 − 1e−6].
/// REQUIRES u_A ≠ u_B, v_ŵ ≠ 0, not both masses infinite, 1/m finite.
/// Laws: (1) afterwards the pair closes at the angle θ from perpendicular: v_n' = −tan θ |v_ŵ'|; (2) the
/// relative speed changes by the factor c_revolve^(θ/π); (3) momentum is conserved; (4) the kinetic energy
/// falls by ½ μ (1 − c_revolve^(2θ/π)) |v_AB|²; (5) lengths times 2^k change nothing, velocities or masses
/// times 2^k multiply Δp by 2^k, bitwise; (6) at θ = 45° a pair on its orbit is back after four events,
/// slower by c_revolve. Angular momentum is not conserved: a tangential first event multiplies it by
/// c_revolve^(θ/π) cos θ.
template <typename Scalar, int D>
Vector<Scalar, D> revolution_impulse(const Vector<Scalar, D>& u_A, const Vector<Scalar, D>& u_B,
                                     const Vector<Scalar, D>& v_A, const Vector<Scalar, D>& v_B,
                                     const std::type_identity_t<Scalar>& m_A,
                                     const std::type_identity_t<Scalar>& m_B,
                                     const std::type_identity_t<Scalar>& c_revolve,
                                     const std::type_identity_t<Scalar>& theta_revolve_deg) {
  return revolution_impulse<Scalar, D>(collision_frame<Scalar, D>(u_A, u_B, v_A, v_B), m_A, m_B, c_revolve,
                                       theta_revolve_deg);
}

}  // namespace tps
