// The angle θ_revolve, given in degrees as scene files do (docs/eq5.md).
#pragma once

#include <cmath>
#include <limits>

namespace tps {

/// π to 120 decimals, rounded once to the scalar (OEIS A000796).
template <typename Scalar>
Scalar pi() {
  static const Scalar value(
      "3.141592653589793238462643383279502884197169399375105820974944"
      "592307816406286208998628034825342117067982148086513282306647");
  return value;
}

template <>
inline float pi<float>() {
  return 3.14159265358979323846264338327950288F;
}
template <>
inline double pi<double>() {
  return 3.14159265358979323846264338327950288;
}
template <>
inline long double pi<long double>() {
  return 3.14159265358979323846264338327950288L;
}

/// θ in degrees as a scalar holds it: the nearest number below 90, so that tan θ is finite (89.999999 is 90
/// in float), and at least 256 ε, so that tan θ is felt beside 1 (1e−6 would not be in float).
template <typename Scalar>
Scalar angle_in_degrees(double theta_deg) {
  const Scalar right(90);
  const Scalar rounded = static_cast<Scalar>(theta_deg);
  const Scalar epsilon = std::numeric_limits<Scalar>::epsilon();
  const Scalar least = Scalar(256) * epsilon;
  if (rounded < least) return least;
  return rounded < right ? rounded : Scalar(right - right * epsilon);
}

/// tan θ for an angle in degrees, 0 < θ < 90.
///
/// tan 45° is exactly 1. Above 45° it is 1 / tan(90° − θ), where 90 − θ is exact: the tangent of a rounded
/// π/2 − ε would lose ε.
/// Law: where 90 − θ is exact, as from 45 on, tan_degrees(θ) · tan_degrees(90 − θ) == 1 to two roundings.
template <typename Scalar>
Scalar tan_degrees(const Scalar& theta_deg) {
  using std::tan;
  const Scalar right(90);
  const Scalar half(45);
  if (theta_deg == half) return Scalar(1);
  const Scalar to_radians = pi<Scalar>() / Scalar(180);
  if (theta_deg > half) return Scalar(1) / Scalar(tan((right - theta_deg) * to_radians));
  return tan(theta_deg * to_radians);
}

}  // namespace tps
