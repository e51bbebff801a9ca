#include "reference/equations/eq7_restitution_impulse.hpp"

#include "reference/equations/eq3_apply_impulse.hpp"
#include "reference/equations/eq4_collision_impulse.hpp"
#include "reference/equations/eq6_load_velocity.hpp"
#include "tests/equations/every_scalar.hpp"

namespace tps::test {

template <typename Scalar>
class Eq7 : public testing::Test {};
TYPED_TEST_SUITE(Eq7, EveryScalar, ScalarName);

// Head-on, v_AB along û: Δp − μ v_AB = c μ v_û.
TYPED_TEST(Eq7, KeepsTheShareOfRestitution) {
  using S = TypeParam;
  const Vector<S, 2> v_A = vec<S>(1, 0), v_B = vec<S>(-3, 0);
  const Vector<S, 2> dp = collision_impulse<S, 2>(vec<S>(0, 0), vec<S>(2, 0), v_A, v_B, S(2), S(2), S(0.5));
  EXPECT_EQ((restitution_impulse<S, 2>(S(2), S(2), v_A, v_B, dp)), (vec<S>(-2, 0)));
}

TYPED_TEST(Eq7, LoadAndRestitutionGiveTheVelocitiesOfTheCollision) {
  using S = TypeParam;
  const Vector<S, 2> v_A = vec<S>(1, 0.3), v_B = vec<S>(-3, 0.9), dp = vec<S>(-5, 0.25);
  const S m_A = S(2), m_B = S(0.7);
  const PairVelocities<S, 2> direct = apply_impulse<S, 2>(m_A, m_B, v_A, v_B, dp);
  const Vector<S, 2> v_load = load_velocity<S, 2>(m_A, m_B, v_A, v_B);
  const Vector<S, 2> dp_AB = restitution_impulse<S, 2>(m_A, m_B, v_A, v_B, dp);
  const PairVelocities<S, 2> grouped = apply_impulse<S, 2>(m_A, m_B, v_load, v_load, dp_AB);
  EXPECT_TRUE((near_by<S, 2>(grouped.v_A, direct.v_A, 12, S(4))));
  EXPECT_TRUE((near_by<S, 2>(grouped.v_B, direct.v_B, 12, S(8))));
}

TYPED_TEST(Eq7, AgainstAWallToo) {
  using S = TypeParam;
  const Vector<S, 2> wall = vec<S>(0, 0), v = vec<S>(-4, 0);
  const Vector<S, 2> dp =
      collision_impulse<S, 2>(vec<S>(0, 0), vec<S>(2, 0), wall, v, infinity<S>(), S(2), S(0.5));
  const Vector<S, 2> dp_AB = restitution_impulse<S, 2>(infinity<S>(), S(2), wall, v, dp);
  EXPECT_EQ(dp_AB, (vec<S>(-4, 0)));
  EXPECT_EQ((apply_impulse<S, 2>(infinity<S>(), S(2), wall, wall, dp_AB).v_B), (vec<S>(2, 0)));
}

// The paper's chain X, Y, Z grouped, by hand: two loads, two restitutions; the velocities are exact
// fractions.
TYPED_TEST(Eq7, TheGroupedChainOfThePaper) {
  using S = TypeParam;
  const S m_Y = S(1) / S(1000), m_XY = S(1) + m_Y;
  const Vector<S, 2> rest = vec<S>(0, 0), left = vec<S>(0, 0), right = vec<S>(1, 0), v_X = vec<S>(1, 0);
  struct Row {
    int c_tenths, v_X, v_X_over, v_YZ, v_YZ_over;
  };
  for (const Row& row : {Row{10, -1, 2001, 2000, 2001}, Row{9, 991, 20010, 1900, 2001}}) {
    const S c = S(row.c_tenths) / S(10);
    const Vector<S, 2> dp_XY = restitution_impulse<S, 2>(
        S(1), m_Y, v_X, rest, collision_impulse<S, 2>(left, right, v_X, rest, S(1), m_Y, c));
    const Vector<S, 2> v_XY = load_velocity<S, 2>(S(1), m_Y, v_X, rest);
    const Vector<S, 2> dp_YZ = restitution_impulse<S, 2>(
        m_XY, S(1), v_XY, rest, collision_impulse<S, 2>(left, right, v_XY, rest, m_XY, S(1), c));
    const Vector<S, 2> v_all = load_velocity<S, 2>(m_XY, S(1), v_XY, rest);
    const PairVelocities<S, 2> outer = apply_impulse<S, 2>(m_XY, S(1), v_all, v_all, dp_YZ);
    const PairVelocities<S, 2> inner = apply_impulse<S, 2>(S(1), m_Y, outer.v_A, outer.v_A, dp_XY);
    EXPECT_TRUE(near_by<S>(inner.v_A[0], S(row.v_X) / S(row.v_X_over), 20, S(1)));
    EXPECT_TRUE(near_by<S>(inner.v_B[0], S(row.v_YZ) / S(row.v_YZ_over), 20, S(1)));
    EXPECT_TRUE(near_by<S>(outer.v_B[0], S(row.v_YZ) / S(row.v_YZ_over), 20, S(1)));
  }
}

}  // namespace tps::test
