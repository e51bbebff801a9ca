#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "properties/responses.hpp"
#include "reference/equations/eq6_load_velocity.hpp"
#include "reference/equations/eq7_restitution_impulse.hpp"

namespace tps::properties {

// Eq. (6) errs by 5u of the speeds, eq. (7) by 6u (|Δp| + μ|v_AB|), each eq. (3) by 1u of Δp/m and of v'.
RC_GTEST_PROP(Eq7Laws, Law1LoadAndRestitutionAreTheCollision, ()) {
  const Masses m = *masses();
  const Vector<double, 3> v_A = *vector<3>(), v_B = *vector<3>(), dp = *vector<3>();
  const Vector<double, 3> v = load_velocity<double, 3>(m.A, m.B, v_A, v_B);
  const Vector<double, 3> dp_AB = restitution_impulse<double, 3>(m.A, m.B, v_A, v_B, dp);
  const PairVelocities<double, 3> grouped = apply_impulse<double, 3>(m.A, m.B, v, v, dp_AB);
  const PairVelocities<double, 3> at_once = apply_impulse<double, 3>(m.A, m.B, v_A, v_B, dp);
  const Wide speeds = wide<3>(v_A).norm() + wide<3>(v_B).norm();
  const Wide momenta = wide<3>(dp).norm() + wide_reduced_mass(m.A, m.B) * speeds;
  const auto agree = [&](double mass, const Vector<double, 3>& x, const Vector<double, 3>& y) {
    const Wide rounding = (5 * speeds + 8 * momenta / Wide(mass) + wide<3>(x).norm() + wide<3>(y).norm()) * u;
    return Vector<Wide, 3>(wide<3>(x) - wide<3>(y)).norm() <= rounding * kSlack;
  };
  RC_ASSERT(agree(m.A, grouped.v_A, at_once.v_A));
  RC_ASSERT(agree(m.B, grouped.v_B, at_once.v_B));
}

// The group has no relative motion; parted by Δp_AB the pair has |Δp_AB|²/2μ of it, if its velocity −Δp_AB/μ
// errs by `applied`.
RC_GTEST_PROP(Eq7Laws, Law2TheEnergyKept, ()) {
  const Masses m = *masses();
  Pair<3> p = *pair<3>();
  p.v_A = p.v_B = *vector<3>();
  const Vector<double, 3> dp_AB = *vector<3>();
  const Response<3> x = respond<3>(p, m, dp_AB);
  const Wide kept = wide<3>(dp_AB).squaredNorm() / (2 * x.mu);
  const Wide speed = wide<3>(dp_AB).norm() / x.mu;
  RC_ASSERT(std::abs(x.mu * x.after.squaredNorm() / 2 - kept) <=
            x.mu * x.applied * (speed + x.applied) * kSlack + 8 * u * kept / 2048);
}

}  // namespace tps::properties
