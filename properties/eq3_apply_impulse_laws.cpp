#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "properties/generators/numbers.hpp"
#include "properties/generators/pairs.hpp"
#include "properties/lifted.hpp"
#include "reference/equations/eq3_apply_impulse.hpp"

namespace tps::properties {

// m v' = m v + Δp + δ₁ Δp + δ₂ m v' for each body and component, |δ| ≤ u.
RC_GTEST_PROP(Eq3Laws, Law1MomentumIsConserved, ()) {
  const Masses m = *finite_masses();
  const Vector<double, 3> v_A = *vector<3>(), v_B = *vector<3>(), dp = *vector<3>();
  const PairVelocities<double, 3> after = apply_impulse<double, 3>(m.A, m.B, v_A, v_B, dp);
  for (int k = 0; k < 3; ++k) {
    const Wide gained =
        Wide(m.A) * (Wide(after.v_A[k]) - Wide(v_A[k])) + Wide(m.B) * (Wide(after.v_B[k]) - Wide(v_B[k]));
    const Wide sizes = 2 * std::abs(Wide(dp[k])) +
                       Wide(m.A) * (std::abs(Wide(after.v_A[k])) + std::abs(Wide(v_A[k]))) +
                       Wide(m.B) * (std::abs(Wide(after.v_B[k])) + std::abs(Wide(v_B[k])));
    RC_ASSERT(std::abs(gained) <= u * sizes * kSlack);
  }
}

RC_GTEST_PROP(Eq3Laws, Law2NoImpulseNoChange, ()) {
  const Masses m = *masses();
  const Vector<double, 3> v_A = *vector<3>(), v_B = *vector<3>();
  const PairVelocities<double, 3> after =
      apply_impulse<double, 3>(m.A, m.B, v_A, v_B, Vector<double, 3>::Zero());
  RC_ASSERT(after.v_A == v_A);
  RC_ASSERT(after.v_B == v_B);
}

RC_GTEST_PROP(Eq3Laws, AnInfiniteMassKeepsItsVelocity, ()) {
  const Vector<double, 3> v_A = *vector<3>(), v_B = *vector<3>(), dp = *vector<3>();
  const double m_B = *finite_mass();
  RC_ASSERT((apply_impulse<double, 3>(HUGE_VAL, m_B, v_A, v_B, dp).v_A) == v_A);
}

}  // namespace tps::properties
