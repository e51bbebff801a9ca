// Honest runs at both ends of a scalar's range, of two balls with masses, lengths and speeds of any
// magnitude: a run that goes on conforms, and one that cannot says so; late starts likewise.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <random>

#include "reference/text/input_error.hpp"
#include "tests/run/traced_run.hpp"
#include "verify/certified/exact_timing.hpp"
#include "verify/trace_check/check.hpp"

namespace tps {
namespace {

using testing::add_particle;

class Magnitudes {
 public:
  explicit Magnitudes(unsigned seed) : random_(seed) {}

  /// A ball at rest and another that flies at it; in a third of the scenes they are tethered, in a third
  /// grouped.
  Scene scene(double lowest, double highest) {
    const double length = magnitude(lowest, highest), speed = magnitude(lowest, highest);
    Scene scene = testing::plain_scene();
    scene.species[0].mass = magnitude(lowest, highest);
    scene.species[0].radius = length / 2;
    const int other = testing::add_species(scene, "other", magnitude(lowest, highest), length / 2);
    testing::block(scene, 0, other, pick({0., .5, 1.}));
    if (pick({0, 0, 1}) == 1) {
      testing::tether(scene, 0, other, 3.5 * length, .5);
      scene.tethers = {{0, 1}};
    }
    if (pick({0, 0, 1}) == 1) scene.grouping = Grouping{length / speed / 8};
    add_particle(scene, 0, {0, 0, 0});
    add_particle(scene, other, {3 * length, pick({0., .25}) * length, 0}, {-speed, 0, 0});
    scene.duration = 20 * length / speed;
    return scene;
  }

  template <typename T>
  T pick(std::initializer_list<T> of) {
    return of.begin()[std::uniform_int_distribution<std::size_t>(0, of.size() - 1)(random_)];
  }

 private:
  double magnitude(double lowest, double highest) {
    if (pick({0, 0, 1}) == 1) return 1;
    return std::pow(10., std::uniform_real_distribution<double>(lowest, highest)(random_));
  }

  std::mt19937 random_;
};

bool is_possible(const Scene& scene) {
  const double length = scene.species[0].radius;
  const bool has_time = scene.duration > 0 && std::isfinite(scene.duration) &&
                        (!scene.grouping || scene.grouping->dt_restitute > 0);
  return length > 0 && std::isfinite(8 * length) && has_time;
}

/// The end of a run that was found to conform; "refused" where it did not begin.
std::string judged_end(const Scene& scene, const std::string& scalar, Timing timing, int n) {
  RunOptions options = testing::options_for(scalar, 20);
  options.timing = can_be_timed(options.scalar, timing) ? timing : Timing::stable;
  certified::ExactTiming certifier;
  options.certifier = &certifier;
  options.trace = testing::scratch("magnitudes.ndjson");
  std::string end;
  try {
    const RunSummary run = run_scene(scene, options);
    EXPECT_LE(run.momentum_drift, run.momentum_bound) << n;
    EXPECT_LE(std::abs(run.energy_remainder), run.energy_bound) << n;
    end = run.end;
  } catch (const InputError&) {
    return "refused";
  }
  const check::CheckReport report = check::check_trace(options.trace);
  const std::string what = report.findings.empty() ? std::string() : report.findings.front().message;
  EXPECT_TRUE(report.conforming()) << n << ' ' << scalar << ' ' << end << ": " << what;
  std::filesystem::remove(options.trace);
  return end;
}

// Impulses, changes of velocity, weights of eq. (6) and times that underflow were lost without a word.
TEST(Magnitudes, WhatRunsConforms) {
  Magnitudes generator(20261126);
  int ran = 0;
  int left = 0;
  for (int n = 0; n < 1500; ++n) {
    const std::string scalar = generator.pick({"float", "double", "double", "long-double"});
    const bool is_float = scalar == "float";
    const Scene scene = generator.scene(is_float ? -46 : -323, is_float ? 40 : 308);
    const Timing timing = generator.pick({Timing::stable, Timing::paper, Timing::certified});
    if (!is_possible(scene)) continue;
    const std::string end = judged_end(scene, scalar, timing, n);
    (end == "out_of_range" || end == "refused" ? left : ran) += 1;
  }
  EXPECT_GE(ran, 300);
  EXPECT_GE(left, 100);
}

/// A ball that comes from afar and grazes another: sums of decimal radii, distances and speeds.
Scene graze_from_afar(double one, double other, double distance, double speed) {
  Scene scene = testing::plain_scene();
  scene.species[0].radius = one;
  const int grazing = testing::add_species(scene, "grazing", 1, other);
  testing::block(scene, 0, grazing, 1);
  add_particle(scene, 0, {0, 0, 0});
  add_particle(scene, grazing, {-distance, std::nearbyint((one + other) * 1e3) / 1e3, 0}, {speed, 0, 0});
  scene.duration = 3 * distance / speed;
  return scene;
}

// While the time is late v_n grows, by as much of |v| as the way is long: which sign it then has at a graze
// is rounding.
TEST(Magnitudes, GrazesAfterALongFlightConform) {
  int n = 0;
  for (const auto& [one, other] : {std::pair(.1, .2), {.7, .1}, {.3, .6}, {.8, .1}, {1.1, 2.2}, {.15, .15}}) {
    for (const double distance : {1e8, 3e8, 1e9, 3e9, 7e9, 2e10, 7e10, 3e11}) {
      for (const double speed : {.3, .7, 1., 1.3}) {
        for (const Timing timing : {Timing::stable, Timing::certified}) {
          const Scene scene = graze_from_afar(one, other, distance, speed);
          judged_end(scene, "double", timing, ++n);
        }
        judged_end(graze_from_afar(one, other, distance / 1e5, speed), "float", Timing::stable, ++n);
      }
    }
  }
}

// The difference of a time and a late start was formed in too few digits.
TEST(Magnitudes, LateStartsConform) {
  for (const char* scalar : {"float", "double", "long-double", "quad", "mp50", "mp100"}) {
    for (const int exponent : {60, 300, 500, 650, 700, 750, 900, 1000}) {
      Scene scene = testing::plain_scene();
      scene.start_time = std::ldexp(1., exponent);
      scene.duration = 10;
      testing::block(scene, 0, 0, 1);
      add_particle(scene, 0, {0, 0, 0});
      add_particle(scene, 0, {3, .25, 0}, {-1, 0, 0});
      EXPECT_EQ(judged_end(scene, scalar, Timing::stable, exponent), "duration");
    }
  }
}

// Two pairs meet so soon after a push that their times differ by less than a number of the check tells.
TEST(Magnitudes, OrderIsTheirTimesHoweverClose) {
  for (const char* scalar : {"long-double", "quad", "mp50", "mp100"}) {
    for (const double speed : {1e100, 1e240, 1e260, 1e300}) {
      Scene scene = testing::plain_scene();
      scene.duration = 3;
      testing::block(scene, 0, 0, 1);
      const double beside[] = {2.5, 2.25};  // the second pair meets first
      for (int n = 0; n < 2; ++n) {
        add_particle(scene, 0, {0, 10. * n, 0});
        add_particle(scene, 0, {beside[n], 10. * n, 0});
        scene.impulses.push_back({1.5, 2 * n, {speed, 0, 0}});
      }
      EXPECT_EQ(judged_end(scene, scalar, Timing::stable, 0), "duration") << speed;
    }
  }
}

// The times of its lines are exact, though no double is start_time + t.
TEST(Magnitudes, EndsBeyondTheDoublesConform) {
  for (const char* scalar : {"double", "long-double", "quad", "mp100"}) {
    for (const double start : {1e308, std::numeric_limits<double>::max()}) {
      Scene scene = testing::plain_scene();
      scene.start_time = start;
      scene.duration = start;
      testing::block(scene, 0, 0, 1);
      add_particle(scene, 0, {0, 0, 0});
      add_particle(scene, 0, {3, .25, 0}, {-0x1p-1021, 0, 0});
      EXPECT_EQ(judged_end(scene, scalar, Timing::stable, 0), "duration");
    }
  }
}

}  // namespace
}  // namespace tps
