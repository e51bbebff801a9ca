// Friction of rough particles after Walton (1993): what a rebound does across the axis. An addition to the
// paper, of which friction and rotation are an outlook; docs/effects.md, "Rotation and friction".
#pragma once

#include <type_traits>

#include "reference/equations/collision_frame.hpp"

namespace tps {

/// Angular velocity: one number in the plane, a vector in space.
template <typename Scalar, int D>
using Spin = Vector<Scalar, D == 2 ? 1 : 3>;

/// I/(m R²): ½ of a disc, ⅖ of a sphere.
template <typename Scalar, int D>
Scalar inertia_ratio() {
  return D == 2 ? Scalar(1) / Scalar(2) : Scalar(2) / Scalar(5);
}

/// x × y in space.
template <typename Scalar>
Vector<Scalar, 3> cross(const Vector<Scalar, 3>& x, const Vector<Scalar, 3>& y) {
  return {Scalar(x[1] * y[2] - x[2] * y[1]), Scalar(x[2] * y[0] - x[0] * y[2]),
          Scalar(x[0] * y[1] - x[1] * y[0])};
}

/// ω × x.
template <typename Scalar, int D>
Vector<Scalar, D> turned(const Spin<Scalar, D>& omega, const Vector<Scalar, D>& x) {
  if constexpr (D == 2) {
    return {Scalar(-omega[0] * x[1]), Scalar(omega[0] * x[0])};
  } else {
    return cross<Scalar>(omega, x);
  }
}

/// x × y.
template <typename Scalar, int D>
Spin<Scalar, D> moment(const Vector<Scalar, D>& x, const Vector<Scalar, D>& y) {
  if constexpr (D == 2) {
    Spin<Scalar, D> result;
    result[0] = x[0] * y[1] - x[1] * y[0];
    return result;
  } else {
    return cross<Scalar>(x, y);
  }
}

/// What friction gives to A across the axis; B gets the opposite.
template <typename Scalar, int D>
struct RoughImpulse {
  Vector<Scalar, D> dp;  ///< J_t, along g_t
  bool sticks;           ///< the surfaces hold each other; else they slide, and μ limits J_t
  Scalar lost;           ///< energy, J_t |g_t| − J_t²/(2 κ m)
};

/// The tangential impulse of a rebound, J_t = min(μ |J_n|, κ (1 + β₀) m |g_t|) along g_t.
///
/// m is the reduced mass and κ = K/(1 + K), K = I/(m R²): the mass that the contact point has across the axis
/// is κ m, whatever masses and radii. g_t = v_ŵ − (R_A ω_A + R_B ω_B) × û is the velocity of B's surface
/// against A's.
/// @param normal   |J_n| ≥ 0, the size of eq. (4)'s impulse
/// @param surface  R_A ω_A + R_B ω_B, a velocity
/// @param mu       coefficient of friction, [0, ∞)
/// @param beta0    tangential restitution of surfaces that stick, [−1, 1]
/// @param K        I/(m R²): in space that of a sphere, 1/2 for discs that stay at z = 0
/// Laws: (1) sticking, g_t' = −β₀ g_t; sliding, J_t = μ |J_n| and g_t' = −β g_t with −1 ≤ β < β₀; (2)
/// momentum, and with spin_change() angular momentum, orbital and spin, are conserved where |u_B − u_A| = R_A
/// + R_B; (3) the energy of motion and spin falls by ½ m ((1 − c²) v_n² + κ (1 − β²) g_t²) with eq. (4); (4)
/// μ = 0 gives nothing, nor does β₀ = −1; (5) a mirror along û changes no size.
template <typename Scalar, int D>
RoughImpulse<Scalar, D> rough_impulse(const CollisionFrame<Scalar, D>& frame,
                                      const std::type_identity_t<Scalar>& m_A,
                                      const std::type_identity_t<Scalar>& m_B,
                                      const std::type_identity_t<Scalar>& normal,
                                      const Spin<Scalar, D>& surface, const std::type_identity_t<Scalar>& mu,
                                      const std::type_identity_t<Scalar>& beta0,
                                      const std::type_identity_t<Scalar>& K = inertia_ratio<Scalar, D>()) {
  const Vector<Scalar, D> g_t = frame.v_w - turned<Scalar, D>(surface, frame.u_hat);
  const Scalar speed = norm<Scalar, D>(g_t);
  const Scalar mass = K / (Scalar(1) + K) * reduced_mass<Scalar>(m_A, m_B);
  const Scalar holding = (Scalar(1) + beta0) * mass * speed;
  const Scalar most = mu * normal;
  const bool sticks = holding <= most;
  const Scalar size = sticks ? holding : most;
  const Vector<Scalar, D> zero = Vector<Scalar, D>::Zero();
  if (!(size > Scalar(0))) return {zero, sticks, Scalar(0)};
  const Scalar lost = size * (speed - size / (Scalar(2) * mass));
  return {
      sticks ? Vector<Scalar, D>((Scalar(1) + beta0) * mass * g_t) : Vector<Scalar, D>(size / speed * g_t),
      sticks, lost};
}

/// What the impulse dp on A at its surface point towards û does to A's spin, (R/I) û × dp = û × dp/(K m R);
/// B's spin, with B's mass and radius, is changed by the same dp: its own is −dp at −R û. Zero for infinite
/// masses. Where K m R is no normal number the velocity û × dp/m is taken first: as many roundings.
template <typename Scalar, int D>
Spin<Scalar, D> spin_change(const Vector<Scalar, D>& u_hat, const Vector<Scalar, D>& dp,
                            const std::type_identity_t<Scalar>& mass,
                            const std::type_identity_t<Scalar>& radius,
                            const std::type_identity_t<Scalar>& K = inertia_ratio<Scalar, D>()) {
  const Scalar lever = K * mass * radius;
  if (lever >= (std::numeric_limits<Scalar>::min)() && (is_finite(lever) || !is_finite(mass)))
    return moment<Scalar, D>(u_hat, dp) / lever;
  return moment<Scalar, D>(u_hat, dp) / mass / (K * radius);
}

}  // namespace tps
