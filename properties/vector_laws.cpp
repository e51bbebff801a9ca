#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "properties/generators/numbers.hpp"
#include "properties/generators/pairs.hpp"
#include "properties/lifted.hpp"
#include "reference/equations/angle.hpp"
#include "reference/equations/collision_frame.hpp"

namespace tps::properties {

RC_GTEST_PROP(VectorLaws, Law1TheOppositeIsAsLong, ()) {
  const Vector<double, 3> x = *vector<3>();
  RC_ASSERT((norm<double, 3>(Vector<double, 3>(-x))) == (norm<double, 3>(x)));
}

RC_GTEST_PROP(VectorLaws, Law2PowersOfTwo, ()) {
  const Vector<double, 3> x = *vector<3>();
  const int k = *rc::gen::inRange(-900, 900);
  RC_ASSERT((norm<double, 3>(shifted<double, 3>(x, k))) == std::ldexp(norm<double, 3>(x), k));
}

RC_GTEST_PROP(CollisionFrameLaws, SwapOfNames, ()) {
  const Pair<3> p = *rc::gen::suchThat(pair<3>(), [](const Pair<3>& q) { return q.u_A != q.u_B; });
  const CollisionFrame<double, 3> f = collision_frame(p.u_A, p.u_B, p.v_A, p.v_B);
  const CollisionFrame<double, 3> g = collision_frame(p.u_B, p.u_A, p.v_B, p.v_A);
  RC_ASSERT(g.v_n == f.v_n);
  RC_ASSERT(g.u_hat == (-f.u_hat).eval());
  RC_ASSERT(g.v_u == (-f.v_u).eval());
  RC_ASSERT(g.v_w == (-f.v_w).eval());
}

RC_GTEST_PROP(CollisionFrameLaws, ReducedMassIsSymmetric, ()) {
  const Masses m = *masses();
  RC_ASSERT(reduced_mass<double>(m.A, m.B) == reduced_mass<double>(m.B, m.A));
}

// Where 90 − θ is exact both tangents come from the same number t: (1/t)·t is 1 to two roundings.
RC_GTEST_PROP(AngleLaws, TangentsOfComplementsAreInverse, ()) {
  const double theta = *revolve_angle();
  RC_PRE(theta > 45);
  const Wide product = tan_degrees<double>(theta) * tan_degrees<double>(90 - theta);
  RC_ASSERT(std::abs(product - 1) <= 2 * u * kSlack);
}

}  // namespace tps::properties
