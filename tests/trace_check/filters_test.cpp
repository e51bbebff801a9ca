// The filters that spare the check most questions never spare it one that matters, at any magnitude.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "verify/trace_check/clear.hpp"
#include "verify/trace_check/paths.hpp"

namespace tps::check {
namespace {

using Random = std::mt19937_64;

double uniform(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

struct Line {
  Coordinates position, velocity;
  double duration;
  StraightLine straight() const {
    double size = 0, speed = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      size += std::fabs(position[k]);
      speed += std::fabs(velocity[k]);
    }
    return {position.data(), velocity.data(), duration, size, speed};
  }
};

bool is_clear(const StraightLine& a, const StraightLine& b, const LimitsInDoubles& limits, double clock) {
  return FirstLook(a, clock, 0x1p-40).is_clear(b, limits);
}

/// Squared distance of two particles, `before` the end of their lines, in long double: products of two stay
/// far inside of its range.
long double squared_distance(const Line& a, const Line& b, long double before) {
  long double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const long double x_a = a.position[k] + a.velocity[k] * (a.duration - before);
    const long double x_b = b.position[k] + b.velocity[k] * (b.duration - before);
    sum += (x_b - x_a) * (x_b - x_a);
  }
  return sum;
}

/// The least one while both flew.
long double nearest(const Line& a, const Line& b) {
  const long double together = std::min(a.duration, b.duration);
  long double rv = 0, vv = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const long double r = (b.position[k] + static_cast<long double>(b.velocity[k]) * b.duration) -
                          (a.position[k] + static_cast<long double>(a.velocity[k]) * a.duration);
    const long double v = static_cast<long double>(b.velocity[k]) - a.velocity[k];
    rv += r * v;
    vv += v * v;
  }
  const long double turned = vv > 0 ? std::clamp(rv / vv, 0.0L, together) : 0.0L;
  return std::min(
      {squared_distance(a, b, 0), squared_distance(a, b, together), squared_distance(a, b, turned)});
}

/// Two particles that fly at each other past a limit of 1, in units of 2^length and 2^speed, and the limit.
struct Passing {
  Line a, b;
  double L;
};

Passing passing(Random& random, int length, int speed) {
  std::normal_distribution<double> normal;
  const double aside = uniform(random, 0, 2);
  const double v = std::exp(uniform(random, -3, 3));
  const double duration = uniform(random, 0, 4) / v;
  const double earlier = uniform(random, 0, 1);
  Passing p{{{normal(random), normal(random), normal(random)}, {0, 0, 0}, duration + earlier},
            {{0, 0, 0}, {-v, .1 * v * normal(random), 0}, duration},
            1};
  p.b.position = {p.a.position[0] + uniform(random, -3, 3), p.a.position[1] + aside, p.a.position[2]};
  for (Line* line : {&p.a, &p.b}) {
    for (std::size_t k = 0; k < 3; ++k) {
      line->position[k] = std::ldexp(line->position[k], length);
      line->velocity[k] = std::ldexp(line->velocity[k], speed);
    }
    line->duration = std::ldexp(line->duration, length - speed);
  }
  p.L = std::ldexp(p.L, length);
  return p;
}

// A pair that is said to be clear is so; at magnitudes of every day most of those that are clear are said to
// be.
TEST(IsClear, IsNeverWrongAtAnyMagnitude) {
  Random random(11);
  int clear = 0, of_every_day = 0, inside = 0;
  for (int n = 0; n < 200'000; ++n) {
    const bool plain = n % 4 == 0;
    const int length = plain ? 0 : std::uniform_int_distribution<int>(-1060, 1010)(random);
    const int speed = plain ? 0 : std::uniform_int_distribution<int>(-1060, 1000)(random);
    if (std::abs(length - speed) > 1000) continue;
    const Passing p = passing(random, length, speed);
    const long double L2 = static_cast<long double>(p.L) * p.L;
    const bool blocked = is_clear(p.a.straight(), p.b.straight(), {p.L, -1}, 0);
    const bool held = is_clear(p.a.straight(), p.b.straight(), {-1, p.L}, 0);
    const long double near = nearest(p.a, p.b);
    EXPECT_TRUE(!blocked || near > L2) << length << ' ' << speed;
    const long double together = std::min(p.a.duration, p.b.duration);
    const long double far = std::max(squared_distance(p.a, p.b, 0), squared_distance(p.a, p.b, together));
    EXPECT_TRUE(!held || far < L2) << length << ' ' << speed;
    if (near < L2) ++inside;
    if (plain && near > L2 * 1.0001L) {
      ++of_every_day;
      if (blocked) ++clear;
    }
  }
  EXPECT_GT(inside, 20'000);
  EXPECT_GT(of_every_day, 5'000);
  EXPECT_EQ(clear, of_every_day);
}

// Late in a run durations are differences of large times.
TEST(IsClear, AllowsForTheClock) {
  const Line a{{0, 0, 0}, {1e4, 0, 0}, 1};
  const Line b{{1e4 + 1, 0, 0}, {0, 0, 0}, 1};
  EXPECT_TRUE(is_clear(a.straight(), b.straight(), {.5, -1}, 0));
  EXPECT_FALSE(is_clear(a.straight(), b.straight(), {.5, -1}, 1e-4));
}

// In a periodic box every image is meant: of pairs that are said to be clear no image came within the limit.
TEST(IsClear, IsNeverWrongInAPeriodicBox) {
  Random random(12);
  constexpr double kEdge = 5;
  const std::array<double, 3> edges = {kEdge, kEdge * 1.25, 0};
  int clear = 0;
  for (int n = 0; n < 4'000; ++n) {
    Passing p = passing(random, 0, 0);
    for (std::size_t k = 0; k < 2; ++k) p.b.position[k] += edges[k] * std::floor(uniform(random, -20, 20));
    if (!FirstLook(p.a.straight(), 0, 0x1p-40, edges.data()).is_clear(p.b.straight(), {p.L, -1})) continue;
    ++clear;
    const Coordinates there = p.b.position;
    for (int x = -22; x <= 22; ++x) {
      for (int y = -22; y <= 22; ++y) {
        p.b.position = {there[0] + x * edges[0], there[1] + y * edges[1], there[2]};
        ASSERT_GT(nearest(p.a, p.b), static_cast<long double>(p.L * p.L)) << n << ' ' << x << ' ' << y;
      }
    }
  }
  EXPECT_GT(clear, 400);
}

TEST(IsClear, SaysNothingAboutWhatIsNoNumber) {
  const double bad[] = {std::nan(""), HUGE_VAL, -HUGE_VAL, 1e308};
  for (const double x : bad) {
    for (int place = 0; place < 3; ++place) {
      Line a{{0, 0, 0}, {0, 0, 0}, 1};
      const Line b{{5, 0, 0}, {0, 0, 0}, 1};
      (place == 0 ? a.position[1] : place == 1 ? a.velocity[1] : a.duration) = x;
      if (place == 2 && x < 0) continue;  // before the flight: nobody is asked
      EXPECT_FALSE(is_clear(a.straight(), b.straight(), {1, 10}, 0)) << x << ' ' << place;
    }
  }
}

std::vector<Path> crowd_of_paths(Random& random, int count, int length, int speed, bool expands) {
  std::vector<Path> paths;
  const double side = std::cbrt(count) * (expands ? 3 : 1);
  for (int n = 0; n < count; ++n) {
    Path path{n, {}, {}, 0};
    for (std::size_t k = 0; k < 3; ++k) {
      const double x = uniform(random, -side, side);
      const double v = expands ? x * uniform(random, .9, 1.1) : uniform(random, -1, 1);
      path.position[k] = std::ldexp(x, length);
      path.velocity[k] = std::ldexp(v, speed);
    }
    paths.push_back(path);
  }
  return paths;
}

/// Whether two come within reach of each other in every coordinate at one time.
bool come_near(const Path& a, const Path& b, long double reach, long double duration) {
  long double from = 0, to = duration;
  for (std::size_t k = 0; k < 3; ++k) {
    const long double r = static_cast<long double>(b.position[k]) - a.position[k];
    const long double v = static_cast<long double>(b.velocity[k]) - a.velocity[k];
    if (v == 0) {
      if (std::fabs(r) > reach) return false;
      continue;
    }
    const long double one = (-reach - r) / v;
    const long double other = (reach - r) / v;
    from = std::max(from, std::min(one, other));
    to = std::min(to, std::max(one, other));
  }
  return from <= to;
}

using Pairs = std::set<std::pair<int, int>>;
Pairs asked_about(const std::vector<Path>& paths, double reach, double duration) {
  Pairs asked;
  Paths(paths, reach).each_near_pair(duration, [&](int i, int j) {
    EXPECT_TRUE(asked.insert(std::minmax(i, j)).second) << "asked twice";
    return true;
  });
  return asked;
}

TEST(PathsAhead, MissNobodyAtAnyMagnitude) {
  Random random(12);
  int met = 0;
  for (const auto& [length, speed] : {std::pair(0, 0), std::pair(-1000, 0), std::pair(-1010, -1000),
                                      std::pair(1000, 1000), std::pair(900, -100), std::pair(-500, -1060)}) {
    for (const double lasts : {.01, 1., 30., HUGE_VAL}) {
      const std::vector<Path> paths = crowd_of_paths(random, 120, length, speed, false);
      const double reach = std::ldexp(1., length);
      const double duration = std::ldexp(lasts, length - speed);
      const Pairs asked = asked_about(paths, reach, duration);
      for (int i = 0; i < 120; ++i) {
        for (int j = i + 1; j < 120; ++j) {
          const auto at = [&](int n) { return paths[static_cast<std::size_t>(n)]; };
          if (!come_near(at(i), at(j), reach, duration)) continue;
          ++met;
          EXPECT_TRUE(asked.contains({i, j})) << length << ' ' << speed << ' ' << lasts;
        }
      }
    }
  }
  EXPECT_GT(met, 1000);
}

// An expanding crowd is settled at a small part of the pairs that it has.
TEST(PathsAhead, LookAtFewWhereNobodyMeets) {
  Random random(13);
  constexpr int kMany = 30'000;
  const Pairs asked = asked_about(crowd_of_paths(random, kMany, 0, 0, true), 1, HUGE_VAL);
  EXPECT_LT(asked.size(), std::size_t{kMany} * 200);
}

// Where everybody is at fault everybody is named, and not every pair.
TEST(PathsAhead, StopAtWhoIsDone) {
  Random random(14);
  constexpr int kCount = 2'000;
  std::size_t asked = 0;
  std::set<int> named;
  Paths(crowd_of_paths(random, kCount, 0, 0, false), 1e6).each_near_pair(HUGE_VAL, [&](int i, int j) {
    ++asked;
    named.insert({i, j});
    return false;
  });
  EXPECT_EQ(named.size(), std::size_t{kCount});
  EXPECT_LE(asked, std::size_t{kCount});
}

}  // namespace
}  // namespace tps::check
