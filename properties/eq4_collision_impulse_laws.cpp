#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Geometry>

#include "properties/responses.hpp"
#include "reference/equations/eq4_collision_impulse.hpp"

namespace tps::properties {
namespace {

struct Rebound {
  Pair<3> p;
  Masses m;
  double c;
  Response<3> x;
  Wide error;  ///< of the relative velocity afterwards
};

// Δp/μ errs by 18u (1 + c)|v_AB|, worst case: v_AB 1u, û 3.5u twice, the scalar product 3u, its product with
// û 1u, μ 3u, 1 + c and the products with it 3u. (Samples reach 5u; docs/eq4.md.) Rounding r adds 1u to û,
// twice.
Rebound collide() {
  const Pair<3> p = *rc::gen::suchThat(pair<3>(), [](const Pair<3>& q) { return q.u_A != q.u_B; });
  const Masses m = *masses();
  const double c = *coefficient();
  const Response<3> x =
      respond<3>(p, m, collision_impulse<double, 3>(p.u_A, p.u_B, p.v_A, p.v_B, m.A, m.B, c));
  return {p, m, c, x, (20 * u * (1 + Wide(c)) * x.before.norm() + x.applied) * kSlack};
}

}  // namespace

RC_GTEST_PROP(Eq4Laws, Law1NormalVelocityTurnsByCAndTangentialStays, ()) {
  const Rebound k = collide();
  const Vector<Wide, 3> n = k.x.r / k.x.r.norm();
  const Vector<Wide, 3> expected = k.x.before - (1 + Wide(k.c)) * k.x.before.dot(n) * n;
  RC_ASSERT((k.x.after - expected).norm() <= k.error);
}

RC_GTEST_PROP(Eq4Laws, Law3EnergyFallsByTheShareOfRestitution, ()) {
  const Rebound k = collide();
  const Wide v_n = parts<3>(k.x.r, k.x.before).normal;
  const Wide lost = (k.x.before.squaredNorm() - k.x.after.squaredNorm()) / 2;
  const Wide expected = (1 - Wide(k.c) * Wide(k.c)) * v_n * v_n / 2;
  RC_ASSERT(std::abs(lost - expected) <= k.error * (k.x.before.norm() + k.error));
}

RC_GTEST_PROP(Eq4Laws, Law4AngularMomentumIsConserved, ()) {
  const Rebound k = collide();
  const Vector<Wide, 3> gained = k.x.r.cross(Vector<Wide, 3>(k.x.after - k.x.before));
  RC_ASSERT(gained.norm() <= k.error * k.x.r.norm());
}

// Law (2), momentum, is law (1) of eq. (3): the impulse enters both bodies as it is. Here the names may be
// swapped.
RC_GTEST_PROP(Eq4Laws, Law2TheImpulseIsOppositeForTheOther, ()) {
  const Rebound k = collide();
  RC_ASSERT((collision_impulse<double, 3>(k.p.u_A, k.p.u_B, k.p.v_A, k.p.v_B, k.m.A, k.m.B, k.c)) ==
            (-collision_impulse<double, 3>(k.p.u_B, k.p.u_A, k.p.v_B, k.p.v_A, k.m.B, k.m.A, k.c)).eval());
}

}  // namespace tps::properties
