// The grid misses nobody, and does not look at everybody.
#include "verify/trace_check/neighbours.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <span>

#include "reference/scene/pair_law.hpp"
#include "reference/scene/scene.hpp"

namespace tps::check {
namespace {

/// Spheres of two sizes in a box, one far-reaching one among them.
/// In units of 2^length.
Scene crowd(int count, int dimension, int length = 0) {
  Scene scene;
  scene.dimension = dimension;
  scene.species = {{"small", 1, 0.25, {}}, {"large", 1, 0.5, {}}, {"wall", HUGE_VAL, 4, {}}};
  for (const auto& [a, b, distance] : {std::tuple(0, 0, 0.5), std::tuple(0, 1, 0.75), std::tuple(1, 1, 1.0),
                                       std::tuple(0, 2, 4.25), std::tuple(1, 2, 4.5)}) {
    scene.pairs.push_back({a, b, BlockingLaw{std::ldexp(distance, length), 1}, std::nullopt});
  }
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> place(0, std::pow(count, 1.0 / dimension) * 2);
  for (int n = 0; n < count; ++n) {
    Particle p{n, n == 0 ? 2 : n % 3 == 0 ? 1 : 0, {}, {}};
    for (int k = 0; k < dimension; ++k)
      p.position[static_cast<std::size_t>(k)] = std::ldexp(place(random), length);
    scene.particles.push_back(p);
  }
  return scene;
}

struct Flying {
  Coordinates position, velocity;
  double since;
  double anchored;  ///< when its anchor was set

  Coordinates at(double t) const {
    Coordinates x;
    for (std::size_t k = 0; k < 3; ++k) x[k] = position[k] + velocity[k] * (t - since);
    return x;
  }
};

/// Of the nearest image, where there are edges. Most are far apart along one axis already.
bool is_nearer(const Scene& scene, const Coordinates& a, const Coordinates& b, double limit) {
  Coordinates r;
  for (std::size_t k = 0; k < 3; ++k) {
    r[k] = a[k] - b[k];
    if (scene.box && std::isfinite(scene.box->edges[k])) r[k] = std::remainder(r[k], scene.box->edges[k]);
    if (std::fabs(r[k]) >= limit) return false;
  }
  return std::hypot(r[0], r[1], r[2]) < limit;
}

/// Follows a crowd whose members change course at random times. Whenever an anchor ends, everybody who came
/// within the blocking distance since the later of the two anchors has to be near.
struct Followed {
  int meetings = 0, missed = 0, asked = 0, looked_at = 0;
};

Followed follow(const Scene& scene, double speed, int length = 0, double start = 0) {
  const int count = static_cast<int>(scene.particles.size());
  const int dimension = scene.dimension;
  Neighbours neighbours(scene);
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal(0, std::ldexp(speed, length));
  std::vector<Flying> all;
  for (const Particle& p : scene.particles) all.push_back({p.position, {}, start, start});
  const auto turn = [&](int i, double now) {
    Flying& f = all[static_cast<std::size_t>(i)];
    f.position = f.at(now);
    f.since = f.anchored = now;
    for (int k = 0; k < dimension; ++k) f.velocity[static_cast<std::size_t>(k)] = i == 0 ? 0 : normal(random);
    neighbours.place(i, f.position, f.velocity, now);
  };
  const auto limit = [&](int i, int j) {
    const int a = scene.particles[static_cast<std::size_t>(i)].species;
    const int b = scene.particles[static_cast<std::size_t>(j)].species;
    const PairLaw* law = pair_law(scene.pairs, a, b);
    return law == nullptr ? 0.0 : law->blocking->distance;
  };
  Followed followed;
  const auto look = [&](int i, double now) {
    const std::span<const int> found = neighbours.near(i);
    const std::vector<int> near(found.begin(), found.end());
    ++followed.asked;
    followed.looked_at += static_cast<int>(near.size());
    const Flying& f = all[static_cast<std::size_t>(i)];
    for (int j = 0; j < count; ++j) {
      if (j == i) continue;
      const Flying& g = all[static_cast<std::size_t>(j)];
      const double from = std::max(f.anchored, g.anchored);
      const double closest = limit(i, j);
      bool met = false;
      for (int step = 0; step <= 8 && !met; ++step) {
        const double t = from + (now - from) * step / 8;
        met = is_nearer(scene, f.at(t), g.at(t), closest);
      }
      if (!met) continue;
      ++followed.meetings;
      if (std::find(near.begin(), near.end(), j) == near.end()) ++followed.missed;
    }
  };
  for (int i = 0; i < count; ++i) turn(i, start);
  std::uniform_int_distribution<int> anyone(1, count - 1);
  std::exponential_distribution<double> waiting(count);
  double now = start;
  for (int event = 0; event < 400; ++event) {
    now += waiting(random);
    while (const auto expired = neighbours.expiry_until(now)) {
      look(expired->particle, expired->t);
      Flying& f = all[static_cast<std::size_t>(expired->particle)];
      f.anchored = expired->t;
      neighbours.place(expired->particle, f.at(expired->t), f.velocity, expired->t);
    }
    const int i = anyone(random);
    look(i, now);
    turn(i, now);
  }
  return followed;
}

Followed follow(int count, int dimension, double speed, int length = 0, double start = 0) {
  return follow(crowd(count, dimension, length), speed, length, start);
}

/// Round two axes, open along the last of three.
Scene boxed(int count, int dimension) {
  Scene scene = crowd(count, dimension);
  const double edge = std::pow(count, 1.0 / dimension) * 2;
  scene.box = PeriodicEdges{{edge, edge * 1.25, HUGE_VAL}};
  return scene;
}

class Crowds : public testing::TestWithParam<std::tuple<int, int, double>> {};

TEST_P(Crowds, NobodyIsMissed) {
  const auto [count, dimension, speed] = GetParam();
  const Followed followed = follow(count, dimension, speed);
  EXPECT_EQ(followed.missed, 0);
  EXPECT_GT(followed.meetings, 50);
}

INSTANTIATE_TEST_SUITE_P(Sizes, Crowds,
                         testing::Values(std::tuple(20, 3, 1.0), std::tuple(200, 3, 1.0),
                                         std::tuple(200, 2, 1.0), std::tuple(200, 3, 30.0),
                                         std::tuple(400, 2, 0.01)));

// Lengths near both ends of the exponent, and times so large that a particle crosses its cell in a few
// roundings of them or less.
TEST(Neighbours, MissNobodyAtAnyMagnitude) {
  for (const auto& [length, start] : {std::pair(-1020, 0.), std::pair(-890, 0.), std::pair(-300, 0.),
                                      std::pair(300, 0.), std::pair(890, 0.), std::pair(1000, 0.),
                                      std::pair(0, 0x1p44), std::pair(0, 0x1p48), std::pair(0, 0x1p51)}) {
    const Followed followed = follow(120, 3, start > 0x1p50 ? 4 : 1, length, start);
    EXPECT_EQ(followed.missed, 0) << length << ' ' << start;
    EXPECT_GT(followed.meetings, 20) << length << ' ' << start;
  }
}

// Particles fly on for many edges; images are met across each.
TEST(Neighbours, MissNoImageInAPeriodicBox) {
  for (const auto& [dimension, speed] : {std::pair(2, 1.), std::pair(3, 30.)}) {
    const Followed followed = follow(boxed(150, dimension), speed);
    EXPECT_EQ(followed.missed, 0) << dimension;
    EXPECT_GT(followed.meetings, 50) << dimension;
    EXPECT_LT(followed.looked_at, 100 * followed.asked) << dimension;
  }
}

TEST(Neighbours, LookAtAFewWhateverTheirNumber) {
  const Followed few = follow(200, 3, 1);
  const Followed many = follow(1600, 3, 1);
  const double per_look_few = static_cast<double>(few.looked_at) / few.asked;
  const double per_look_many = static_cast<double>(many.looked_at) / many.asked;
  EXPECT_LT(per_look_few, 60);
  EXPECT_LT(per_look_many, 1.5 * per_look_few);
}

// Without any blocking nobody has to be looked for.
TEST(Neighbours, AreNobodyWhereNothingBlocks) {
  Scene scene = crowd(100, 3);
  for (PairLaw& law : scene.pairs) law.blocking.reset();
  Neighbours neighbours(scene);
  EXPECT_TRUE(neighbours.near(7).empty());
}

}  // namespace
}  // namespace tps::check
