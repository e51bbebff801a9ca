// Doubles judged in a wider type. Law checks evaluate their two sides in long double, whose roundoff is 2^-11
// of double's: `kSlack` covers it where a bound is derived for double alone.
#pragma once

#include <cmath>
#include <limits>

#include "reference/equations/vector.hpp"

namespace tps::properties {

using Wide = long double;

inline constexpr Wide u = std::numeric_limits<double>::epsilon() / 2;  // unit roundoff of double
inline constexpr Wide kSlack = 1.02L;

template <int D>
Vector<Wide, D> wide(const Vector<double, D>& x) {
  return x.template cast<Wide>();
}

/// μ without a division by infinity.
inline Wide wide_reduced_mass(double m_A, double m_B) {
  if (std::isinf(m_A)) return m_B;
  if (std::isinf(m_B)) return m_A;
  return Wide(m_A) * Wide(m_B) / (Wide(m_A) + Wide(m_B));
}

/// The parts of a relative velocity along and across an axis.
struct Parts {
  Wide normal, tangential;
};

template <int D>
Parts parts(const Vector<Wide, D>& r, const Vector<Wide, D>& v) {
  const Vector<Wide, D> n = r / r.norm();
  const Wide normal = v.dot(n);
  return {normal, (v - normal * n).norm()};
}

}  // namespace tps::properties
