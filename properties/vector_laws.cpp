// Laws of what the equations are made of and the interface does not show.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "properties/generators/numbers.hpp"
#include "properties/generators/pairs.hpp"
#include "reference/equations/angle.hpp"
#include "reference/equations/collision_frame.hpp"

namespace tps::properties {
namespace {

using Vec = Vector<double, 3>;

Vec vec(const Vec3& x) {
  return {x[0], x[1], x[2]};
}
Vec any_vector() {
  return vec(vector({}, 3));
}

RC_GTEST_PROP(VectorLaws, Law1TheOppositeIsAsLong, ()) {
  const Vec x = any_vector();
  RC_ASSERT((norm<double, 3>(Vec(-x))) == (norm<double, 3>(x)));
}

RC_GTEST_PROP(VectorLaws, Law2PowersOfTwo, ()) {
  const Vec x = any_vector();
  const int k = whole(-900, 900);
  RC_ASSERT((norm<double, 3>(shifted<double, 3>(x, k))) == std::ldexp(norm<double, 3>(x), k));
}

RC_GTEST_PROP(CollisionFrameLaws, SwapOfNames, ()) {
  Case c;
  put_pair(c, {});
  const PairState p = c.pair();
  RC_PRE(p.u_A != p.u_B);
  const auto f = collision_frame(vec(p.u_A), vec(p.u_B), vec(p.v_A), vec(p.v_B));
  const auto g = collision_frame(vec(p.u_B), vec(p.u_A), vec(p.v_B), vec(p.v_A));
  RC_ASSERT(g.v_n == f.v_n);
  RC_ASSERT(g.u_hat == (-f.u_hat).eval());
  RC_ASSERT(g.v_u == (-f.v_u).eval());
  RC_ASSERT(g.v_w == (-f.v_w).eval());
}

RC_GTEST_PROP(CollisionFrameLaws, ReducedMassIsSymmetric, ()) {
  const Masses m = masses({});
  RC_ASSERT(reduced_mass<double>(m.A, m.B) == reduced_mass<double>(m.B, m.A));
}

// Where 90 − θ is exact both tangents come from the same number t: (1/t)·t is 1 to two roundings.
RC_GTEST_PROP(AngleLaws, TangentsOfComplementsAreInverse, ()) {
  const double theta = revolve_angle({});
  RC_PRE(theta > 45);
  const long double product =
      static_cast<long double>(tan_degrees<double>(theta)) * tan_degrees<double>(90 - theta);
  RC_ASSERT(std::abs(product - 1) <= 1.02L * std::numeric_limits<double>::epsilon());
}

}  // namespace
}  // namespace tps::properties
