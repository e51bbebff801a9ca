// What rounding may do to the relative velocity after a response, v_AB' = v_AB − Δp/μ. Heavy header: only
// sources of laws include it.
#pragma once

#include "properties/laws/compare.hpp"

namespace tps::properties {

/// Eq. (4): Δp/μ errs by 18u (1 + c)|v_AB|, worst case: v_AB 1u, û 3.5u twice, the scalar product 3u, its
/// product with û 1u, μ 3u, 1 + c and the products with it 3u. (Samples reach 5u; docs/eq4.md.) Rounding r
/// adds 1u to û, twice.
inline Wide collision_error(const Encounter& x, double c, const Wide& u) {
  return 20 * u * (1 + Wide(c)) * x.speed * kSlack;
}

/// Eq. (5): v_ŵ errs by 15u |v_AB| (v_AB, û twice, scalar product, product, difference), so its direction by
/// 15u |v_AB|/|v_ŵ|. Then tan θ 6u, two lengths 2.5u, a unit vector 3.5u, c^(θ/π) 1.5u (rounding θ/180 costs
/// |c^x ln c^x| u ≤ u/e), the difference and μ 5u, the product with μ and Δp itself 2.5u.
inline Wide revolution_error(const Encounter& x, const Wide& u) {
  return (15 * x.speed / x.tangential + 21) * u * x.speed * kSlack;
}

inline Wide radians(double degrees) {
  static const Wide pi = acos(Wide(-1));
  return Wide(degrees) * pi / 180;
}

/// c_revolve^(θ/π).
inline Wide speed_ratio(double c_revolve, double theta) {
  if (c_revolve == 0) return 0;
  return pow(Wide(c_revolve), Wide(theta) / 180);
}

/// v_AB' of eq. (5): at θ from perpendicular, inward.
inline WideVector revolved(const Encounter& x, double c_revolve, double theta) {
  const Wide angle = radians(theta);
  return speed_ratio(c_revolve, theta) * x.speed * ((cos(angle) / x.tangential) * x.w - sin(angle) * x.n);
}

/// The part across the axis below which the errors above say nothing.
inline bool turns(const Encounter& x) {
  return x.tangential * 1000 >= x.speed && x.speed > 0;
}

}  // namespace tps::properties
