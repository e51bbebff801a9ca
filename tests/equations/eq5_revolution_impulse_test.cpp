#include "reference/equations/eq5_revolution_impulse.hpp"

#include "reference/equations/eq3_apply_impulse.hpp"
#include "tests/equations/every_scalar.hpp"

namespace tps::test {

template <typename Scalar>
class Eq5 : public testing::Test {};
TYPED_TEST_SUITE(Eq5, EveryScalar, ScalarName);

// The paper's example: θ = 45°, c_revolve = 0.5: four collisions a revolution, 0.5^(1/4) ≈ 0.84 each.
TYPED_TEST(Eq5, FourCollisionsARevolutionAtTheFourthRootOfOneHalf) {
  using S = TypeParam;
  using std::abs;
  const CollisionFrame<S, 2> f =
      collision_frame<S, 2>(vec<S>(0, 0), vec<S>(1, 0), vec<S>(0, 0), vec<S>(0, 1));
  const Revolution<S, 2> q = revolution<S, 2>(f, S(0.5), S(45));
  const S ratio = q.speed_ratio;
  EXPECT_TRUE(near_by<S>(ratio * ratio * ratio * ratio, S(0.5), 12, S(0.5)));
  EXPECT_LT(abs(ratio - S(0.84)), S(0.001));
  EXPECT_EQ(q.v_revolve, (vec<S>(-1, 1)));
}

TYPED_TEST(Eq5, ClosesAtThetaFromPerpendicular) {
  using S = TypeParam;
  const Vector<S, 2> u_A = vec<S>(0, 0), u_B = vec<S>(3, 4), v_A = vec<S>(0.3, 0), v_B = vec<S>(-0.5, 1);
  for (const double theta : {5.0, 30.0, 45.0, 60.0, 85.0}) {
    const Vector<S, 2> dp = revolution_impulse<S, 2>(u_A, u_B, v_A, v_B, S(2), S(3), S(0.5), S(theta));
    const PairVelocities<S, 2> after = apply_impulse<S, 2>(S(2), S(3), v_A, v_B, dp);
    const CollisionFrame<S, 2> f = collision_frame<S, 2>(u_A, u_B, after.v_A, after.v_B);
    const S tan_theta = tan_degrees<S>(S(theta));
    EXPECT_TRUE(near_by<S>(f.v_n, -tan_theta * norm<S, 2>(f.v_w), 24, S(1) + tan_theta)) << theta;
  }
}

TYPED_TEST(Eq5, SpeedRatioAtTheEndsOfTheCoefficient) {
  using S = TypeParam;
  const CollisionFrame<S, 2> f =
      collision_frame<S, 2>(vec<S>(0, 0), vec<S>(1, 0), vec<S>(0, 0), vec<S>(0, 1));
  EXPECT_EQ((revolution<S, 2>(f, S(1), S(30)).speed_ratio), S(1));
  EXPECT_EQ((revolution<S, 2>(f, S(0), S(30)).speed_ratio), S(0));
  EXPECT_EQ((revolution_impulse<S, 2>(f, S(2), S(2), S(0), S(30))), (vec<S>(0, 1)));  // all motion is taken
}

TYPED_TEST(Eq5, AnInfiniteMassTakesPart) {
  using S = TypeParam;
  const Vector<S, 2> dp = revolution_impulse<S, 2>(vec<S>(0, 0), vec<S>(1, 0), vec<S>(0, 0), vec<S>(0, 1),
                                                   infinity<S>(), S(2), S(1), S(45));
  const PairVelocities<S, 2> after = apply_impulse<S, 2>(infinity<S>(), S(2), vec<S>(0, 0), vec<S>(0, 1), dp);
  EXPECT_EQ(after.v_A, (vec<S>(0, 0)));
  EXPECT_TRUE(near_by<S>(after.v_B[0], -after.v_B[1], 8, S(1)));
  EXPECT_TRUE(near_by<S>(after.v_B.squaredNorm(), S(1), 12, S(1)));
}

TYPED_TEST(Eq5, RetractionSufficesStrictly) {
  using S = TypeParam;
  const auto frame = [](double v_n, double v_w) {
    return collision_frame<S, 2>(vec<S>(0, 0), vec<S>(1, 0), vec<S>(0, 0), vec<S>(v_n, v_w));
  };
  EXPECT_TRUE((retraction_suffices<S, 2>(frame(3, 1), S(0.5), S(1))));
  EXPECT_FALSE((retraction_suffices<S, 2>(frame(2, 1), S(0.5), S(1))));  // equal: not above
  EXPECT_FALSE((retraction_suffices<S, 2>(frame(1, 1), S(0.5), S(1))));
  EXPECT_FALSE((retraction_suffices<S, 2>(frame(0, 1), S(1), S(1))));
  EXPECT_TRUE((retraction_suffices<S, 2>(frame(1, 0), S(0), S(1))));  // the guard: v_ŵ = 0
  EXPECT_TRUE((retraction_suffices<S, 2>(frame(0, 0), S(1), S(1))));
}

TEST(Eq5Range, SpeedsWhoseSquaresLeaveTheRange) {
  for (const double s : {1e-200, 1e200}) {
    const CollisionFrame<double, 2> f = collision_frame<double, 2>({0, 0}, {1, 0}, {0, 0}, {0, s});
    const Revolution<double, 2> q = revolution<double, 2>(f, 1.0, 45.0);
    EXPECT_NEAR(q.v_AB_after[0] / s, -std::sqrt(0.5), 1e-15);
    EXPECT_NEAR(q.v_AB_after[1] / s, std::sqrt(0.5), 1e-15);
  }
}

}  // namespace tps::test
