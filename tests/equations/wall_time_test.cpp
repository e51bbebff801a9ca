// The time to a plane: verdicts, laws and edges.
#include "reference/equations/wall_time.hpp"

#include "tests/equations/every_scalar.hpp"

namespace tps::test {
namespace {

template <typename Scalar>
class WallTime : public testing::Test {};
TYPED_TEST_SUITE(WallTime, EveryScalar, ScalarName);

template <typename S>
CollisionTime<S> time_to_floor(double height, double v_z, double L = 1) {
  return wall_time<S, 3>(vec<S>(0, 0, 0), vec<S>(5, -7, height), vec<S>(0, 0, 0), vec<S>(2, 3, v_z), S(L),
                         vec<S>(0, 0, 1));
}

TYPED_TEST(WallTime, EveryVerdict) {
  using S = TypeParam;
  const auto hit = time_to_floor<S>(4, -2);
  EXPECT_EQ(hit.verdict, TimingVerdict::hit);
  EXPECT_EQ(*hit.t, S(1.5));
  EXPECT_EQ(time_to_floor<S>(1, -2).verdict, TimingVerdict::contact);
  EXPECT_EQ(*time_to_floor<S>(1, -2).t, S(0));
  EXPECT_EQ(time_to_floor<S>(0.5, -2).verdict, TimingVerdict::overlap);
  EXPECT_EQ(*time_to_floor<S>(-3, -2).t, S(0));
  EXPECT_EQ(time_to_floor<S>(1, 0).verdict, TimingVerdict::receding);
  EXPECT_FALSE(time_to_floor<S>(0.5, 2).t);
  const auto still =
      wall_time<S, 2>(vec<S>(0, 0), vec<S>(0, 2), vec<S>(1, 1), vec<S>(1, 1), S(1), vec<S>(0, 1));
  EXPECT_EQ(still.verdict, TimingVerdict::static_pair);
}

// Law (2): any point of the plane. Laws (3) and (4): powers of two, and what both have in common.
TYPED_TEST(WallTime, WhatChangesNothing) {
  using S = TypeParam;
  const S zero(0), t = *time_to_floor<S>(4, -2).t;
  const Vector<S, 3> up = vec<S>(0, 0, 1);
  const auto elsewhere =
      wall_time<S, 3>(vec<S>(64, -32, 0), vec<S>(5, -7, 4), vec<S>(0, 0, 0), vec<S>(2, 3, -2), S(1), up);
  EXPECT_EQ(*elsewhere.t, t);
  const auto twice =
      wall_time<S, 3>(vec<S>(0, 0, 0), vec<S>(10, -14, 8), vec<S>(0, 0, 0), vec<S>(4, 6, -4), S(2), up);
  EXPECT_EQ(*twice.t, t);
  const auto moving =
      wall_time<S, 3>(vec<S>(1, 1, 8), vec<S>(6, -6, 12), vec<S>(1, 2, 4), vec<S>(3, 5, 2), S(1), up);
  EXPECT_EQ(*moving.t, t);
  EXPECT_GT(t, zero);
}

// Law (1), along a normal that is no vector of the scalar.
TYPED_TEST(WallTime, AtTheTimeTheGapIsClosed) {
  using S = TypeParam;
  const Vector<S, 2> n = vec<S>(0.6, 0.8);
  const Vector<S, 2> u = vec<S>(3, 1), v = vec<S>(-1, -0.25);
  const auto hit = wall_time<S, 2>(vec<S>(0, 0), u, vec<S>(0, 0), v, S(0.5), n);
  using std::abs;
  const S rest = n.dot(Vector<S, 2>(u + v * *hit.t)) - S(0.5);
  EXPECT_LE(S(abs(rest)), S(32) * roundoff<S>());  // terms up to 3, ten roundings
}

}  // namespace
}  // namespace tps::test
