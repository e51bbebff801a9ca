#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "properties/generators/numbers.hpp"
#include "properties/generators/pairs.hpp"
#include "properties/lifted.hpp"
#include "reference/equations/eq6_load_velocity.hpp"

namespace tps::properties {

// A weight errs by 3u (ratio, sum, inverse), its product by 1u, the sum by 1u.
RC_GTEST_PROP(Eq6Laws, Law1MomentumOfThePairIsThatOfTheGroup, ()) {
  const Masses m = *finite_masses();
  const Vector<double, 3> v_A = *vector<3>(), v_B = *vector<3>();
  const Vector<double, 3> v = load_velocity<double, 3>(m.A, m.B, v_A, v_B);
  for (int k = 0; k < 3; ++k) {
    const Wide A = Wide(m.A) * Wide(v_A[k]), B = Wide(m.B) * Wide(v_B[k]);
    RC_ASSERT(std::abs((Wide(m.A) + Wide(m.B)) * Wide(v[k]) - A - B) <=
              5 * u * (std::abs(A) + std::abs(B)) * kSlack);
  }
}

RC_GTEST_PROP(Eq6Laws, Law2BetweenTheTwoVelocities, ()) {
  const Masses m = *masses();
  const Vector<double, 3> v_A = *vector<3>(), v_B = *vector<3>();
  const Vector<double, 3> v = load_velocity<double, 3>(m.A, m.B, v_A, v_B);
  for (int k = 0; k < 3; ++k) {
    const Wide rounding = 5 * u * std::max(std::abs(Wide(v_A[k])), std::abs(Wide(v_B[k]))) * kSlack;
    RC_ASSERT(Wide(v[k]) >= Wide(std::min(v_A[k], v_B[k])) - rounding);
    RC_ASSERT(Wide(v[k]) <= Wide(std::max(v_A[k], v_B[k])) + rounding);
  }
}

}  // namespace tps::properties
