// What both timing queries of eq. (2) are decided by: the quadratic in half-b form, with each coefficient
// computed so that rounding costs as little as the working precision allows (docs/eq2.md).
#pragma once

#include <cmath>
#include <limits>
#include <type_traits>

#include "reference/equations/square_root.hpp"
#include "reference/equations/vector.hpp"

namespace tps {

/// The quadratic a t² + 2 h t + c = 0 whose roots are the times at distance L, eq. (2) with b = 2h.
template <typename Scalar>
struct Approach {
  Scalar a;  ///< |v|², relative speed squared
  Scalar h;  ///< r·v: negative while approaching
  Scalar c;  ///< |r|² − L²: negative inside the limit
  Scalar D;  ///< h² − a c: negative when the limit is never reached
};

/// |r × v|² by its minors; in 2-D the square of the one minor there is.
template <typename Scalar>
Scalar cross_squared(const Vector<Scalar, 2>& r, const Vector<Scalar, 2>& v) {
  const Scalar minor = r[0] * v[1] - r[1] * v[0];
  return minor * minor;
}

template <typename Scalar>
Scalar cross_squared(const Vector<Scalar, 3>& r, const Vector<Scalar, 3>& v) {
  const Scalar x = r[1] * v[2] - r[2] * v[1];
  const Scalar y = r[2] * v[0] - r[0] * v[2];
  const Scalar z = r[0] * v[1] - r[1] * v[0];
  return x * x + y * y + z * z;
}

/// |r × v|, also where its square would underflow.
template <typename Scalar>
Scalar cross_norm(const Vector<Scalar, 2>& r, const Vector<Scalar, 2>& v) {
  using std::abs;
  return abs(Scalar(r[0] * v[1] - r[1] * v[0]));
}

template <typename Scalar>
Scalar cross_norm(const Vector<Scalar, 3>& r, const Vector<Scalar, 3>& v) {
  return norm<Scalar, 3>(
      Vector<Scalar, 3>(r[1] * v[2] - r[2] * v[1], r[2] * v[0] - r[0] * v[2], r[0] * v[1] - r[1] * v[0]));
}

/// D = a L² − |r × v|² where L is so far below |r| that L² vanishes beside |r|²: by its two factors, and
/// where even their product underflows as the smallest number of its sign. Its size does not matter there (√D
/// vanishes beside |h|), its sign is the verdict.
template <typename Scalar, int D>
Scalar discriminant_from_afar(const Vector<Scalar, D>& r, const Vector<Scalar, D>& v, const Scalar& a,
                              const Scalar& L) {
  const Scalar reach = square_root(a) * L;
  const Scalar moment = cross_norm<Scalar>(r, v);
  const Scalar product = (reach - moment) * (reach + moment);
  if (product != Scalar(0) || reach == moment) return product;
  const Scalar smallest = (std::numeric_limits<Scalar>::min)();
  return reach > moment ? smallest : Scalar(-smallest);
}

/// Coefficients of eq. (2) from the relative position r, the relative velocity v and the limit L.
///
/// Departs from the paper's b² − 4ac by identities that hold exactly in real arithmetic:
///   c = (|r| − L)(|r| + L) for |r| < 2L: there the subtraction is exact, so c errs by the rounding of |r|
///   alone (by nothing where r lies along an axis, as in a line of particles); from farther |r|² − L², as
///   printed, cancels little and has fewer roundings; D = a L² − |r × v|² (Lagrange) where h² ≥ a L², that is
///   from afar, where h² and a c would cancel; D = h² − a c where h² < a L², that is near the limit; inside
///   it (c < 0) two positive terms are added.
/// Errors, in units u of rounding: h by u |r||v|, the minors of r × v likewise, c by u |r|(|r| + L) at most,
/// so D by a few u (a L² + |r × v||r||v|) in the first form and a few u a (|r| + L)² in the second. The first
/// is what rounding r does to it, and no form does better from rounded r; docs/eq2.md has the bounds. Law:
/// approach(r, v, L) == approach(−r, −v, L) bitwise, so it does not matter who is called A.
template <typename Scalar, int D>
Approach<Scalar> approach(const Vector<Scalar, D>& r, const Vector<Scalar, D>& v,
                          const std::type_identity_t<Scalar>& L) {
  const Scalar a = v.squaredNorm();
  const Scalar h = r.dot(v);
  const Scalar r_squared = r.squaredNorm();
  const Scalar L_squared = L * L;
  const bool near_limit = r_squared < Scalar(4) * L_squared;
  const Scalar distance = near_limit ? Scalar(square_root(r_squared)) : Scalar(0);
  const Scalar c = near_limit ? Scalar((distance - L) * (distance + L)) : Scalar(r_squared - L_squared);
  const Scalar h_squared = h * h;
  const Scalar a_L_squared = a * L_squared;
  static const Scalar vanishing =
      (std::numeric_limits<Scalar>::min)() / std::numeric_limits<Scalar>::epsilon();
  if (a_L_squared < vanishing) return {a, h, c, discriminant_from_afar<Scalar, D>(r, v, a, L)};
  const Scalar discriminant =
      h_squared < a_L_squared ? Scalar(h_squared - a * c) : Scalar(a_L_squared - cross_squared(r, v));
  return {a, h, c, discriminant};
}

/// A timing query with lengths and velocities scaled by powers of two, which is exact.
template <typename Scalar, int D>
struct ScaledQuery {
  Vector<Scalar, D> r, v;
  Scalar L;
  int time_exponent;  ///< the answer is t · 2^time_exponent
};

/// Scales r and L by one power of two and v by another, so that no square over- or underflows that
/// matters: |v| = 1e155 or 1e−170 would otherwise make a = |v|² infinite or zero. Within the comfortable
/// range (a quarter of the exponents, so that a L² and |r × v|² have room) nothing is changed.
///
/// Where L is below |r| by more than half the exponent range (2^-500 in double), L² vanishes beside |r|² all
/// the same (discriminant_from_afar); below it by more than the whole range, L becomes the smallest number.
///
/// REQUIRES v ≠ 0, L > 0, all finite.
template <typename Scalar, int D>
ScaledQuery<Scalar, D> scaled_query(const Vector<Scalar, D>& r, const Vector<Scalar, D>& v, const Scalar& L) {
  using std::abs;
  using std::frexp;
  using std::ldexp;
  static const Scalar small = ldexp(Scalar(1), std::numeric_limits<Scalar>::min_exponent / 8);
  static const Scalar large = ldexp(Scalar(1), std::numeric_limits<Scalar>::max_exponent / 8);
  Scalar length = L;
  Scalar speed = Scalar(0);
  for (int k = 0; k < D; ++k) {
    if (abs(r[k]) > length) length = abs(r[k]);
    if (abs(v[k]) > speed) speed = abs(v[k]);
  }
  if (length > small && length < large && speed > small && speed < large) return {r, v, L, 0};
  int length_exponent = 0;
  int speed_exponent = 0;
  static_cast<void>(frexp(length, &length_exponent));
  static_cast<void>(frexp(speed, &speed_exponent));
  ScaledQuery<Scalar, D> scaled{r, v, ldexp(L, -length_exponent), length_exponent - speed_exponent};
  if (scaled.L == Scalar(0)) scaled.L = (std::numeric_limits<Scalar>::min)();
  for (int k = 0; k < D; ++k) {
    scaled.r[k] = ldexp(r[k], -length_exponent);
    scaled.v[k] = ldexp(v[k], -speed_exponent);
  }
  return scaled;
}

}  // namespace tps
