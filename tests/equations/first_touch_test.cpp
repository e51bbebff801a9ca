// On which side of a plane a particle is when it first touches: against roots in long double, and where both
// come at one moment.
#include "reference/equations/first_touch.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace tps::test {
namespace {

template <typename S>
Vector<S, 3> at(int x, int y, int z) {
  return {S(x), S(y), S(z)};
}

// Towards an edge along z at distance 5 by the axis (3, 4): it touches at t = 1, at the height 2 + w.
TEST(FirstTouch, AtOneMomentItIsOnThePlane) {
  const auto side = [](int w, int c) {
    const FirstTouch<double, 3> touch(at<double>(0, 0, 0), at<double>(6, 8, 2), at<double>(0, 0, 0),
                                      at<double>(-3, -4, w), 5, {true, true, false});
    return touch.side(2, c);
  };
  EXPECT_EQ(side(1, 3), 0);
  EXPECT_EQ(side(1, 4), -1);
  EXPECT_EQ(side(1, 2), 1);
  EXPECT_EQ(side(-4, -2), 0);
  EXPECT_EQ(side(-4, -1), -1);
  EXPECT_EQ(side(0, 2), 0);
}

// Grazing: the double root is the touch. Already within: it touches now.
TEST(FirstTouch, GrazesAndOverlaps) {
  const FirstTouch<double, 2> graze({0, 0}, {-4, 5}, {0, 0}, {2, 0}, 5, {true, true, false});
  EXPECT_EQ(graze.side(0, 0), 0);
  EXPECT_EQ(graze.side(0, -1), 1);
  const FirstTouch<double, 2> within({0, 0}, {-3, 0}, {0, 0}, {2, 0}, 5, {true, true, false});
  EXPECT_EQ(within.side(0, -2), -1);
}

template <typename S, int D>
int compared_with_roots(unsigned seed) {
  std::mt19937 draw(seed);
  const auto whole = [&](int most) {
    return static_cast<int>(draw() % (2U * static_cast<unsigned>(most) + 1U)) - most;
  };
  int decided = 0;
  for (int n = 0; n < 3000; ++n) {
    const std::array<bool, 3> measured{true, n % 2 == 0, D == 3 && n % 3 == 0};
    Vector<S, D> u_A, u_B, v_A, v_B;
    for (int k = 0; k < D; ++k)
      u_A[k] = S(whole(5)), u_B[k] = S(whole(9)), v_A[k] = S(whole(2)), v_B[k] = S(whole(4));
    const int L = 1 + static_cast<int>(draw() % 6U);
    long double a = 0, h = 0, q = -static_cast<long double>(L * L);
    for (int k = 0; k < D; ++k) {
      if (!measured[static_cast<std::size_t>(k)]) continue;
      const long double r = static_cast<long double>(u_B[k] - u_A[k]),
                        w = static_cast<long double>(v_B[k] - v_A[k]);
      a += w * w, h += r * w, q += r * r;
    }
    const bool at_once = q <= 0;
    if (!at_once && (h >= 0 || h * h < a * q)) continue;  // never
    const long double t = at_once ? 0 : q / (-h + std::sqrt(h * h - a * q));
    const FirstTouch<S, D> touch(u_A, u_B, v_A, v_B, S(L), measured);
    for (int k = 0; k < D; ++k) {
      const int c = whole(6);
      const long double x =
          static_cast<long double>(u_B[k]) - c + static_cast<long double>(v_B[k] - v_A[k]) * t;
      const int expected = std::abs(x) < 1e-12L ? 0
                           : x < 0              ? -1
                                                : 1;  // of small integers and one root: 0 or above 1e-6
      EXPECT_EQ(touch.side(k, S(c)), expected) << n << ' ' << k;
      ++decided;
    }
  }
  return decided;
}

TEST(FirstTouch, AgreesWithRoots) {
  EXPECT_GT((compared_with_roots<double, 3>(1)), 2000);
  EXPECT_GT((compared_with_roots<double, 2>(2)), 2000);
  EXPECT_GT((compared_with_roots<float, 2>(3)), 2000);
  EXPECT_GT((compared_with_roots<long double, 3>(4)), 2000);
}

}  // namespace
}  // namespace tps::test
