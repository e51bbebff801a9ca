#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "properties/responses.hpp"
#include "reference/equations/tether_response.hpp"

namespace tps::properties {
namespace {

struct Turn {
  Pair<3> p;
  Masses m;
  double c, theta;
  Response<3> x;
  Wide error;  ///< of the relative velocity afterwards
};

Wide radians(double degrees) {
  return Wide(degrees) * std::acos(Wide(-1)) / 180;
}
Wide speed_ratio(double c, double theta) {
  return std::pow(Wide(c), Wide(theta) / 180);
}

// v_ŵ errs by 15u |v_AB| (v_AB, û twice, scalar product, product, difference), so its direction by 15u
// |v_AB|/|v_ŵ|. Then tan θ 6u, two lengths 2.5u, a unit vector 3.5u, c^(θ/π) 1.5u (rounding θ/180 costs |c^x
// ln c^x| u ≤ u/e), the difference and μ 5u.
Wide impulse_error(const Vector<Wide, 3>& r, const Vector<Wide, 3>& v) {
  const Wide tangential = parts<3>(r, v).tangential;
  return (15 * v.norm() / tangential + 21) * u * v.norm();
}

Turn revolve() {
  const Pair<3> p = *turning_pair<3>();
  const Masses m = *masses();
  const double c = *coefficient(), theta = *revolve_angle();
  const Vector<double, 3> dp = revolution_impulse<double, 3>(p.u_A, p.u_B, p.v_A, p.v_B, m.A, m.B, c, theta);
  const Response<3> x = respond<3>(p, m, dp);
  return {p, m, c, theta, x, (impulse_error(x.r, x.before) + x.applied) * kSlack};
}

}  // namespace

RC_GTEST_PROP(Eq5Laws, Law1ClosesAtThetaFromPerpendicular, ()) {
  const Turn k = revolve();
  const Parts after = parts<3>(k.x.r, k.x.after);
  const Wide angle = radians(k.theta);
  RC_ASSERT(std::abs(after.normal * std::cos(angle) + after.tangential * std::sin(angle)) <= 2 * k.error);
}

RC_GTEST_PROP(Eq5Laws, Law2SpeedFallsByTheRatioOfOneCollision, ()) {
  const Turn k = revolve();
  RC_ASSERT(std::abs(k.x.after.norm() - speed_ratio(k.c, k.theta) * k.x.before.norm()) <= k.error);
}

RC_GTEST_PROP(Eq5Laws, Law4EnergyFallsByTheSquareOfTheRatio, ()) {
  const Turn k = revolve();
  const Wide ratio = speed_ratio(k.c, k.theta);
  const Wide lost = (k.x.before.squaredNorm() - k.x.after.squaredNorm()) / 2;
  const Wide expected = (1 - ratio * ratio) * k.x.before.squaredNorm() / 2;
  RC_ASSERT(std::abs(lost - expected) <= k.error * (k.x.before.norm() + k.error));
}

RC_GTEST_PROP(Eq5Laws, Law3TheImpulseIsOppositeForTheOther, ()) {
  const Turn k = revolve();
  RC_ASSERT((revolution_impulse<double, 3>(k.p.u_A, k.p.u_B, k.p.v_A, k.p.v_B, k.m.A, k.m.B, k.c, k.theta)) ==
            (-revolution_impulse<double, 3>(k.p.u_B, k.p.u_A, k.p.v_B, k.p.v_A, k.m.B, k.m.A, k.c, k.theta))
                .eval());
}

RC_GTEST_PROP(TetherResponseLaws, ClosesAtThetaOrMore, ()) {
  const Pair<3> p = *turning_pair<3>();
  const CollisionFrame<double, 3> f = collision_frame(p.u_A, p.u_B, p.v_A, p.v_B);
  RC_PRE(f.v_n >= 0);
  const Masses m = *masses();
  const double c_retract = *coefficient(), theta = *revolve_angle();
  const TetherResponse<double, 3> answer =
      tether_response<double, 3>(f, m.A, m.B, c_retract, *coefficient(), theta);
  const Response<3> x = respond<3>(p, m, answer.dp);
  const Parts after = parts<3>(x.r, x.after);
  const Wide angle = radians(theta);
  // Eq. (4) errs by 40u |v_AB| at most (eq4_collision_impulse_laws.cpp), eq. (5) by impulse_error.
  const Wide error = (40 * u * x.before.norm() + impulse_error(x.r, x.before) + x.applied) * kSlack;
  RC_CLASSIFY(answer.kind == TetherResponseKind::revolve);
  RC_ASSERT(after.normal * std::cos(angle) + after.tangential * std::sin(angle) <= 2 * error);
}

}  // namespace tps::properties
