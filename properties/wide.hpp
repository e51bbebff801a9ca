// Numbers in which laws are judged: 150 digits, so that the sides of a law are exact beside the rounding of
// any scalar. Heavy header: only sources of laws include it.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>

#include "properties/case.hpp"
#include "reference/equations/wide_square_root.hpp"

namespace tps::properties {

using Wide =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<150>, boost::multiprecision::et_off>;

/// Covers products of errors in bounds that add up first orders: (1 + u)^80 − 1 < 1.02 · 80u for u ≤ 2^-24.
inline const Wide kSlack("1.02");

struct WideVector {
  Wide x, y, z;
};

inline WideVector wide(const Vec3& a) {
  return {Wide(a[0]), Wide(a[1]), Wide(a[2])};
}
inline WideVector operator+(const WideVector& a, const WideVector& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline WideVector operator-(const WideVector& a, const WideVector& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline WideVector operator*(const Wide& s, const WideVector& a) {
  return {s * a.x, s * a.y, s * a.z};
}
inline WideVector operator/(const WideVector& a, const Wide& s) {
  return {a.x / s, a.y / s, a.z / s};
}
inline bool operator==(const WideVector& a, const WideVector& b) {
  return a.x == b.x && a.y == b.y && a.z == b.z;
}
inline Wide dot(const WideVector& a, const WideVector& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline WideVector cross(const WideVector& a, const WideVector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Wide norm(const WideVector& a) {
  return square_root(dot(a, a));
}

/// The components one by one.
inline std::array<Wide, 3> components(const WideVector& a) {
  return {a.x, a.y, a.z};
}

/// 1/m; 1/∞ = 0.
inline Wide inverse_mass(double m) {
  return std::isinf(m) ? Wide(0) : 1 / Wide(m);
}

/// μ without a division by infinity.
inline Wide reduced_mass(const Masses& m) {
  return 1 / (inverse_mass(m.A) + inverse_mass(m.B));
}

}  // namespace tps::properties
