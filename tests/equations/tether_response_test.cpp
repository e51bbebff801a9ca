#include "reference/equations/tether_response.hpp"

#include "reference/equations/eq2_collision_time.hpp"
#include "reference/equations/eq3_apply_impulse.hpp"
#include "tests/equations/every_scalar.hpp"

namespace tps::test {

template <typename Scalar>
class TetherAnswer : public testing::Test {};
TYPED_TEST_SUITE(TetherAnswer, EveryScalar, ScalarName);

TYPED_TEST(TetherAnswer, RetractsWhereItSufficesElseRevolves) {
  using S = TypeParam;
  const auto answer = [](double v_n, double v_w) {
    const CollisionFrame<S, 2> f =
        collision_frame<S, 2>(vec<S>(0, 0), vec<S>(1, 0), vec<S>(0, 0), vec<S>(v_n, v_w));
    return tether_response<S, 2>(f, S(2), S(2), S(0.5), S(1), S(45));
  };
  EXPECT_EQ(answer(4, 1).kind, TetherResponseKind::retract);
  EXPECT_EQ(answer(4, 1).dp, (vec<S>(6, 0)));
  EXPECT_EQ(answer(2, 1).kind, TetherResponseKind::revolve);  // the boundary itself
  EXPECT_EQ(answer(0, 1).kind, TetherResponseKind::revolve);
  EXPECT_EQ(answer(4, 0).kind, TetherResponseKind::retract);
}

// A pair that starts tangentially at its limit R2 = 1 with |v| = 1, θ = 45°, c_revolve = ½: times and speeds
// to the last of the six printed digits. Chords of 2 R2 sin θ at speeds 2^(−k/4).
TYPED_TEST(TetherAnswer, TableOfARevolvingPair) {
  using S = TypeParam;
  using std::abs;
  constexpr double times[] = {0, 1.681793, 3.681793, 6.060207, 8.888634};
  constexpr double speeds[] = {.840896, .707107, .594604, .5, .420448};
  const S m(1), c_retract(0.5), c_revolve(0.5), theta(45);
  Vector<S, 2> u_A = vec<S>(0, 0), u_B = vec<S>(1, 0), v_A = vec<S>(0, -0.5), v_B = vec<S>(0, 0.5);
  S clock(0);
  for (int k = 0; k < 5; ++k) {
    const S t = *tether_time<S, 2>(u_A, u_B, v_A, v_B, S(1)).t;
    clock += t;
    u_A += v_A * t;
    u_B += v_B * t;
    const CollisionFrame<S, 2> f = collision_frame<S, 2>(u_A, u_B, v_A, v_B);
    const TetherResponse<S, 2> response = tether_response<S, 2>(f, m, m, c_retract, c_revolve, theta);
    EXPECT_EQ(response.kind, TetherResponseKind::revolve) << k;
    const PairVelocities<S, 2> after = apply_impulse<S, 2>(m, m, v_A, v_B, response.dp);
    v_A = after.v_A;
    v_B = after.v_B;
    const S half_digit = S(5e-7) + S(64) * roundoff<S>();
    EXPECT_LE(abs(clock - S(times[k])), half_digit) << k;
    EXPECT_LE(abs(norm<S, 2>(v_B - v_A) - S(speeds[k])), half_digit) << k;
  }
}

}  // namespace tps::test
