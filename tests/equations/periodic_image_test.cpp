// Differences to an image: exact ones against their laws, rounded ones against exact ones.
#include "reference/equations/periodic_image.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace tps {
namespace periodic_image_test {

Dyadic size(const Dyadic& x) {
  return x.sign() < 0 ? -x : x;
}

/// Of a pair far from home by up to a million edges, whose images are near.
template <typename Scalar, int D>
struct RandomPair {
  Vector<Scalar, D> u_A, u_B;
  PeriodicImage<Scalar, D> image;

  explicit RandomPair(std::mt19937_64& random) {
    const auto uniform = [&](double low, double high) {
      return Scalar(std::uniform_real_distribution<double>(low, high)(random));
    };
    for (int k = 0; k < D; ++k) {
      image.edges[k] = uniform(3, 9);
      image.n[k] = std::floor(uniform(-1e6, 1e6));
      u_A[k] = uniform(-9, 9);
      u_B[k] = u_A[k] + uniform(-2, 2) - image.shift(k);
    }
  }
};

/// Each of three roundings is at most u of what it rounds to.
template <typename Scalar, int D>
void is_rounded_thrice() {
  std::mt19937_64 random(7);
  const Dyadic u = dyadic(Scalar(std::numeric_limits<Scalar>::epsilon() / Scalar(2)));
  int inexact = 0;
  for (int n = 0; n < 2000; ++n) {
    const RandomPair<Scalar, D> pair(random);
    const Vector<Scalar, D> r = pair.image.difference(pair.u_A, pair.u_B);
    for (int k = 0; k < D; ++k) {
      const Dyadic off = dyadic(r[k]) - pair.image.exact_difference(pair.u_A, pair.u_B, k);
      const Scalar difference = pair.u_B[k] - pair.u_A[k];
      const Dyadic bound =
          u * (size(dyadic(difference)) + size(dyadic(pair.image.shift(k))) + size(dyadic(r[k])));
      EXPECT_LE((size(off) - bound).sign(), 0) << n << ' ' << k;
      inexact += off.sign() != 0;
    }
  }
  EXPECT_GT(inexact, 1000);
}

TEST(PeriodicImage, DifferencesAreRoundedThrice) {
  is_rounded_thrice<float, 2>();
  is_rounded_thrice<double, 3>();
  is_rounded_thrice<long double, 2>();
}

/// Names exchanged, and B an edge further with one edge less, leave the exact difference what it was.
TEST(PeriodicImage, ExactDifferencesKnowNoNamesAndNoHome) {
  std::mt19937_64 random(8);
  for (int n = 0; n < 2000; ++n) {
    RandomPair<double, 3> pair(random);
    PeriodicImage<double, 3> back = pair.image;
    back.n = -back.n;
    for (int k = 0; k < 3; ++k) {
      const Dyadic r = pair.image.exact_difference(pair.u_A, pair.u_B, k);
      EXPECT_EQ((r + back.exact_difference(pair.u_B, pair.u_A, k)).sign(), 0);
      PeriodicImage<double, 3> whole = pair.image;
      whole.edges[k] = 4;
      Vector<double, 3> there = pair.u_A, further = pair.u_A;
      there[k] = 0.375;
      further[k] = 0.375 + 4;
      const Dyadic here = whole.exact_difference(pair.u_A, there, k);
      whole.n[k] -= 1;
      EXPECT_EQ((here - whole.exact_difference(pair.u_A, further, k)).sign(), 0);
    }
  }
}

/// Places of a pair are its own, or A at 0 and the image of B.
TEST(PeriodicImage, PlacesAreWhereTheDifferenceIs) {
  std::mt19937_64 random(9);
  const RandomPair<double, 2> pair(random);
  PairPlaces<double, 2> places{pair.u_A, pair.u_B, {}};
  EXPECT_EQ(places.from(), pair.u_A);
  EXPECT_EQ(places.to(), pair.u_B);
  EXPECT_EQ(places.exact(), nullptr);
  places.image = pair.image;
  EXPECT_EQ(places.to() - places.from(), pair.image.difference(pair.u_A, pair.u_B));
  EXPECT_EQ(places.exact()->n, pair.image.n);
}

}  // namespace periodic_image_test
}  // namespace tps
