// The outside of a box against times that are known exactly, and against an oracle that knows distances
// alone.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <random>
#include <string>
#include <utility>

#include "reference/engine/simulation.hpp"
#include "reference/run/audit.hpp"
#include "tests/run/traced_run.hpp"
#include "verify/certified/exact_timing.hpp"

namespace tps {
namespace box_outside {

using testing::add_particle;
using testing::TracedEvent;

/// A block from low to high, and a ball of radius ½.
Scene block(int dimension, Coordinates low, Coordinates high, Coordinates position, Coordinates velocity) {
  Scene scene = testing::plain_scene(dimension);
  Wall wall;
  wall.shape = Wall::Shape::box;
  wall.inside = false;
  wall.point = low;
  wall.high = high;
  scene.walls = {wall};
  add_particle(scene, 0, position, velocity);
  scene.duration = 64;
  return scene;
}

testing::TracedRun run_with(const Scene& scene, Timing timing, const char* scalar = "double") {
  certified::ExactTiming certifier;
  RunOptions options = testing::options_for(scalar, 50);
  options.timing = timing;
  options.certifier = &certifier;
  return testing::traced(scene, options);
}

constexpr Timing kTimings[] = {Timing::paper, Timing::stable, Timing::certified};

struct Known {
  const char* part;
  int dimension;
  Coordinates position, velocity;
  double t;
  Coordinates after;
};

// A block from (0, 0, 0) to (4, 2, 8), met on a face, on an edge along z by an axis (3, 4)/5, on corners by
// the axes (3, 4)/5 and (2, 3, 6)/7: radius ½ · 1 or 7/2 · 1/7 away all numbers are short.
TEST(BoxOutside, FacesEdgesAndCornersAreMetWhenKnown) {
  const Known cases[] = {
      {"\"face\":0", 2, {-3, 1, 0}, {1, 0, 0}, 2.5, {-1, 0, 0}},
      {"\"face\":1", 2, {8, 1.5, 0}, {-1, .125, 0}, 3.5, {1, .125, 0}},
      {"\"face\":3", 3, {1, 5, 2}, {.25, -1, .5}, 2.5, {.25, 1, .5}},
      {"\"face\":4", 2, {-3, -4, 0}, {.75, 1, 0}, 3.6, {-.75, -1, 0}},
      {"\"face\":9", 3, {7, 6, 2}, {-.75, -1, .5}, 3.6, {.75, 1, .5}},
      {"\"face\":25", 3, {6, 5, 14}, {-.5, -.75, -1.5}, 26. / 7, {.5, .75, 1.5}},
  };
  for (const Known& known : cases) {
    for (const Timing timing : kTimings) {
      const Scene scene = block(known.dimension, {0, 0, 0}, {4, 2, known.dimension == 3 ? 8. : 0},
                                known.position, known.velocity);
      const testing::TracedRun run = run_with(scene, timing);
      ASSERT_EQ(run.events.size(), 1U) << known.part;
      EXPECT_NE(run.bytes.find(known.part), std::string::npos) << known.part << run.bytes;
      EXPECT_NEAR(run.events[0].t, known.t, 1e-14) << known.part;
      for (std::size_t k = 0; k < static_cast<std::size_t>(known.dimension); ++k)
        EXPECT_NEAR(run.events[0].post.at(0).velocity[k], known.after[k], 1e-14) << known.part;
      EXPECT_LE(std::abs(run.summary.energy_remainder), run.summary.energy_bound);
    }
  }
}

// Exactly a radius beside it nothing happens, also where the ball passes from a face to a corner; by a bit
// less it is touched there, by a bit more it is not. (The printed rule calls a graze an event.)
TEST(BoxOutside, WhoSlidesAlongAFaceIsNotTouched) {
  for (const Timing timing : {Timing::stable, Timing::certified}) {
    for (const double x : {-3., 1., 5.}) {
      const Scene beside = block(2, {0, 0, 0}, {4, 2, 0}, {x, 2.5, 0}, {x < 2 ? .75 : -.75, 0, 0});
      EXPECT_TRUE(run_with(beside, timing).events.empty()) << x;
    }
    const Scene above = block(2, {0, 0, 0}, {4, 2, 0}, {-3, 2.5 + 0x1p-51, 0}, {.75, 0, 0});
    EXPECT_TRUE(run_with(above, timing).events.empty());
    const Scene below = block(2, {0, 0, 0}, {4, 2, 0}, {-3, 2.5 - 0x1p-20, 0}, {.75, 0, 0});
    const testing::TracedRun touched = run_with(below, timing);
    ASSERT_EQ(touched.events.size(), 1U);
    EXPECT_NE(touched.bytes.find("\"face\":5"), std::string::npos);  // low x, high y
    EXPECT_LT(touched.events[0].pre.at(0).position[0], 0);
  }
}

// c = 0 leaves the ball on the face; it slides off it past the edge, and meets nothing more.
TEST(BoxOutside, ABallThatRestsOnAFaceSlidesOffIt) {
  for (const Timing timing : {Timing::stable, Timing::certified}) {
    Scene scene = block(2, {0, 0, 0}, {4, 2, 0}, {1, 4, 0}, {.5, -1, 0});
    scene.walls[0].c_rebound = 0;
    const testing::TracedRun run = run_with(scene, timing);
    ASSERT_EQ(run.events.size(), 1U);
    EXPECT_EQ(run.events[0].post.at(0).velocity, (std::vector<double>{.5, 0}));
    EXPECT_EQ(run.summary.audit_inner_excess, 0);
  }
}

/// A ball that slides along a face of a block towards its edge, or falls on the face first and stays on it
/// (c = 0), a rounding off on either side; with short numbers, or with all their digits.
class Slides {
 public:
  Scene next() {
    const int dimension = 2 + pick(2);
    is_short_ = pick(3) == 0;
    falls_ = pick(2) == 1;
    Coordinates low{}, high{}, position{}, velocity{};
    for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k) {
      low[k] = uniform(-1, 1);
      high[k] = low[k] + uniform(.5, 2);
      position[k] = low[k] + (high[k] - low[k]) * uniform(.25, .75);
      velocity[k] = pick(4) == 0 ? 0 : uniform(-1, 1);
    }
    const auto across = static_cast<std::size_t>(pick(dimension));
    const double side = pick(2) == 1 ? 1 : -1, radius = uniform(.125, .5);
    const double face = side > 0 ? high[across] : low[across];
    position[across] = face + side * (falls_ ? radius + .25 : radius);
    // A start that is nearer than the radius is refused.
    while (side * (position[across] - face) < radius)
      position[across] = std::nextafter(position[across], side * HUGE_VAL);
    velocity[across] = falls_ ? -4 * side : 0;
    Scene scene = block(dimension, low, high, position, velocity);
    scene.species[0].radius = radius;
    scene.walls[0].c_rebound = falls_ ? 0 : .5;
    return scene;
  }
  bool falls() const { return falls_; }

 private:
  int pick(int n) { return static_cast<int>(draw_() % static_cast<unsigned>(n)); }
  double uniform(double low, double high) {
    const double x = low + (high - low) * (static_cast<double>(draw_()) * 0x1p-32);
    return is_short_ ? std::round(x * 64) / 64 : x;
  }

  std::mt19937 draw_{11};
  bool is_short_ = false, falls_ = false;
};

// It is exactly at its distance from the edge, or a rounding farther or nearer: tangent, past, or already
// within it. Rounded, h² − ac may be above 0 in all three.
TEST(BoxOutside, WhoSlidesPastAnEdgeIsNotThrownOffByIt) {
  Slides slides;
  for (int n = 0; n < 200; ++n) {
    const Scene scene = slides.next();
    for (const Timing timing : kTimings) {
      for (const char* scalar : {"double", "float", "long-double", "mp50"}) {
        const bool is_native = scalar == std::string("double") || scalar == std::string("float");
        if (!is_native && (n % 8 > 0 || timing == Timing::certified)) continue;
        if (scalar == std::string("float") && !slides.falls())
          continue;  // a start rounded to float is nearer
        const testing::TracedRun run = run_with(scene, timing, scalar);
        ASSERT_EQ(run.events.size(), slides.falls() ? 1U : 0U) << n << ' ' << scalar << '\n' << run.bytes;
      }
    }
  }
}

long double distance(const Wall& wall, const std::array<long double, 3>& u, int dimension) {
  long double square = 0;
  for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k) {
    const long double beyond = std::max({wall.point[k] - u[k], u[k] - wall.high[k], 0.0L});
    square += beyond * beyond;
  }
  return std::sqrt(square);
}

/// The first time at which a point that flies straight is within L of a box: distance is convex, so that its
/// minimum is found by thirds, and the time before it by halves. Nothing where the minimum is within 1e-6 of
/// L.
std::optional<std::optional<long double>> touch(const Scene& scene, long double L) {
  const Particle& p = scene.particles[0];
  const auto at = [&](long double t) {
    std::array<long double, 3> u{};
    for (std::size_t k = 0; k < 3; ++k) u[k] = p.position[k] + p.velocity[k] * t;
    return distance(scene.walls[0], u, scene.dimension);
  };
  long double from = 0, until = 64;
  for (int n = 0; n < 200; ++n) {
    const long double a = from + (until - from) / 3, b = until - (until - from) / 3;
    (at(a) < at(b) ? until : from) = at(a) < at(b) ? b : a;
  }
  const long double nearest = from;
  if (std::abs(at(nearest) - L) < 1e-6L) return std::nullopt;
  if (at(nearest) > L) return std::optional<long double>{};
  from = 0, until = nearest;
  for (int n = 0; n < 200; ++n) (at((from + until) / 2) > L ? from : until) = (from + until) / 2;
  return std::optional<long double>{until};
}

/// What the engine says of the only particle's first event, and how near it is afterwards.
struct FirstEvent {
  double t;
  int part = -1;
  double excess = 0;
};

template <int D>
FirstEvent first_event(const Scene& scene) {
  Simulation<double, D> run(scene);
  FirstEvent first{run.next_time().hi};
  run.world().sink = [&](const Record<double, D>& record) { first.part = record.addition->face.value(); };
  if (!std::isfinite(first.t)) return first;
  run.step();
  first.excess = audit_bounds(run.world(), run.world().now).inner;
  return first;
}

TEST(BoxOutside, RandomFlightsMeetItWhenTheDistanceSays) {
  std::mt19937 draw(7);  // its numbers are the same everywhere; distributions of the library are not
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * (static_cast<double>(draw()) * 0x1p-32);
  };
  std::array<int, 26> met{};
  int missed = 0;
  for (int n = 0; n < 4000; ++n) {
    const int dimension = 2 + n % 2;
    const double flat = dimension == 3 ? 1 : 0;
    Scene scene = block(dimension, {-.7, -.4, -.9 * flat}, {.6, 1.1, .8 * flat}, {}, {});
    Particle& p = scene.particles[0];
    do {
      p.position = {uniform(-4, 4), uniform(-4, 4), uniform(-4, 4) * flat};
    } while (distance(scene.walls[0], {p.position[0], p.position[1], p.position[2]}, dimension) <= .5L);
    for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k)
      p.velocity[k] = (uniform(-1.2, 1.2) - p.position[k]) / 4;
    const auto expected = touch(scene, .5L);
    if (!expected) continue;
    const FirstEvent found = dimension == 3 ? first_event<3>(scene) : first_event<2>(scene);
    ASSERT_EQ(std::isfinite(found.t), expected->has_value()) << n;
    if (!*expected) {
      ++missed;
      continue;
    }
    EXPECT_NEAR(found.t, static_cast<double>(**expected), 1e-12)
        << n;  // 16 u of the way over the least v_n, 1e-3
    if (dimension == 3) ++met[static_cast<std::size_t>(found.part)];
    EXPECT_LE(found.excess, 8) << n;  // landing
  }
  EXPECT_GE(missed, 100);
  EXPECT_GE(*std::min_element(met.begin(), met.end()), 5);
}

TEST(BoxOutside, TheAuditFindsWhoIsInsideOrTooNear) {
  Scene scene = block(2, {0, 0, 0}, {4, 2, 0}, {-3, 1, 0}, {});
  for (const auto& [x, y] : {std::pair{2., 1.}, {-.25, 1.}, {2., 2.25}, {4.25, 2.25}, {.25, .5}}) {
    Simulation<double, 2> run(scene);
    EXPECT_EQ(audit_bounds(run.world(), {1, 0}).inner, 0);
    run.world().particles[0].position = {x, y};
    EXPECT_GT(audit_bounds(run.world(), {1, 0}).inner, .1 / 0x1p-50) << x << ' ' << y;
  }
}

TEST(BoxOutside, PartsHaveNames) {
  const auto plane = surfaces(block(2, {0, 0, 0}, {4, 2, 0}, {-3, 1, 0}, {}));
  const auto space = surfaces(block(3, {0, 0, 0}, {4, 2, 8}, {-3, 1, 0}, {}));
  ASSERT_EQ(plane.size(), 8U);
  ASSERT_EQ(space.size(), 26U);
  EXPECT_EQ(surface_name(plane[3]), "wall 0, face 3 (high y)");
  EXPECT_EQ(surface_name(plane[5]), "wall 0, corner 5 (low x, high y)");
  EXPECT_EQ(surface_name(space[6]), "wall 0, edge 6 (low x, low y)");
  EXPECT_EQ(surface_name(space[17]), "wall 0, edge 17 (high y, high z)");
  EXPECT_EQ(surface_name(space[25]), "wall 0, corner 25 (high x, high y, high z)");
}

// In the frame of the block it is at rest.
TEST(BoxOutside, ABlockMayMove) {
  for (const Timing timing : kTimings) {
    Scene scene = block(2, {0, 0, 0}, {4, 2, 0}, {-3, -4, 0}, {.25, 1, 0});
    scene.walls[0].velocity = {-.5, 0, 0};
    const testing::TracedRun run = run_with(scene, timing);
    ASSERT_EQ(run.events.size(), 1U);
    EXPECT_NEAR(run.events[0].t, 3.6, 3e-15);
    EXPECT_NEAR(run.events[0].post.at(0).velocity[0], -1.25, 1e-14);
    EXPECT_NEAR(run.events[0].post.at(0).velocity[1], -1, 1e-14);
  }
}

}  // namespace box_outside
}  // namespace tps
