// A particle and a plane in real arithmetic. Heavy header: only sources of laws include it.
#pragma once

#include "properties/case.hpp"
#include "properties/laws/compare.hpp"
#include "properties/wide.hpp"

namespace tps::properties {

/// n·r − L and −n·v in real arithmetic. In the numbers of the implementation the first errs by 6u(Σ|n_k r_k|
/// + L), the second by 5u Σ|n_k v_k| (a difference, a product, two sums, one more for L), their quotient by
/// u.
struct PlaneApproach {
  PlaneApproach(const PairState& p, double L, const Vec3& normal, const Wide& u)
      : is_static(p.v_A == p.v_B), gap(-Wide(L)), gap_error(L), towards(0), towards_error(0) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Wide of_r = Wide(normal[k]) * (Wide(p.u_B[k]) - Wide(p.u_A[k]));
      const Wide of_v = Wide(normal[k]) * (Wide(p.v_A[k]) - Wide(p.v_B[k]));
      gap += of_r;
      gap_error += abs(of_r);
      towards += of_v;
      towards_error += abs(of_v);
    }
    gap_error *= 6 * u * kSlack;
    towards_error *= 5 * u * kSlack;
  }

  /// By how much the way flown in t may miss the gap.
  Wide residual(const Wide& t, const Wide& u) const {
    return gap_error + t * (towards_error + 2 * u * abs(towards));
  }

  bool is_static;
  Wide gap, gap_error, towards, towards_error;
};

}  // namespace tps::properties
