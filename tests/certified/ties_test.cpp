// Events so close that only exact order tells which is first, as whole runs.
#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>

#include "tests/run/traced_run.hpp"
#include "verify/certified/exact_timing.hpp"

namespace tps {
namespace {

using Rational = boost::multiprecision::cpp_rational;
using testing::add_particle;
using testing::TracedRun;

TracedRun timed(const Scene& scene, Timing timing, const std::string& scalar = "double") {
  certified::ExactTiming certifier;
  RunOptions options = testing::options_for(scalar);
  options.timing = timing;
  options.certifier = &certifier;
  options.state_every = 1;
  return testing::traced(scene, options);
}

std::pair<int, int> first_pair(const TracedRun& run) {
  return {run.events.at(0).i, run.events.at(0).j};
}

/// Where a pair stands at a time, as rationals: the sign of |r + v t|² − L².
int beyond_limit(double r_x, double r_y, double t, double L) {
  const Rational x = Rational(r_x) + Rational(t);
  const Rational squared = x * x + Rational(r_y) * Rational(r_y) - Rational(L) * Rational(L);
  return squared.sign();
}

/// Particle "middle" at rest is hit by two others at nearly the same moment: from the left head-on at exactly
/// t, from the right with an offset at 3 − √(1 − offset²), irrational, which rounds to t.
struct NearTie {
  double offset, t;
  bool oblique_first;
};

// By the stable formula both are at t, so that ids decide.
const NearTie kNearTies[] = {{.25, 0x1.0410853ac2c4ap+1, true},
                             {.625, 0x1.1c147cfa94b1ep+1, true},
                             {.125, 0x1.010102050e2a8p+1, false},
                             {.0625, 0x1.0040100805038p+1, false}};

/// The ids are such that the tie by ids is wrong.
Scene near_tie_scene(const NearTie& tie) {
  Scene scene = testing::plain_scene();
  testing::block(scene, 0, 0);
  const Coordinates head_on = {-(1 + tie.t), 0, 0};
  const Coordinates oblique = {3, tie.offset, 0};
  add_particle(scene, 0, tie.oblique_first ? head_on : oblique, {tie.oblique_first ? 1. : -1., 0, 0});
  add_particle(scene, 0, {0, 0, 0});
  add_particle(scene, 0, tie.oblique_first ? oblique : head_on, {tie.oblique_first ? -1. : 1., 0, 0});
  return scene;
}

TEST(Ties, WithinAnUlpTheExactlyEarlierEventIsFirst) {
  for (const NearTie& tie : kNearTies) {
    const bool inside_at_t = beyond_limit(-3, tie.offset, tie.t, 1) < 0;
    ASSERT_EQ(inside_at_t, tie.oblique_first) << "inside at t: the limit was reached before";
    const Scene scene = near_tie_scene(tie);
    const TracedRun stable = timed(scene, Timing::stable);
    const TracedRun certified = timed(scene, Timing::certified);
    EXPECT_EQ(first_pair(stable), std::pair(0, 1)) << tie.offset;
    EXPECT_EQ(first_pair(certified), std::pair(1, 2)) << tie.offset;
    EXPECT_EQ(certified.events.at(0).t, tie.t);
    // Who strikes the middle one first changes what comes out, by far more than rounding.
    EXPECT_GT(std::abs(stable.events.back().post.at(1).velocity[1] -
                       certified.events.back().post.at(1).velocity[1]),
              1e-6)
        << tie.offset;
    ASSERT_TRUE(certified.summary.certified);
    EXPECT_GT(certified.summary.certified->order.calls, 0U);
  }
}

/// Two pairs out of each other's reach, each with limit 5: (−10, 3) and (x, 0), approaching at speed 1.
Scene two_pairs(double x, bool aligned_first) {
  Scene scene = testing::plain_scene();
  scene.species[0].radius = 2.5;
  testing::block(scene, 0, 0);
  const auto add = [&](double r_x, double r_y, double away) {
    add_particle(scene, 0, {0, away, 0});
    add_particle(scene, 0, {r_x, away + r_y, 0}, {1, 0, 0});
  };
  if (aligned_first) add(x, 0, 1024);
  add(-10, 3, 0);
  if (!aligned_first) add(x, 0, 1024);
  return scene;
}

TEST(Ties, AnExactTieGoesByIdsAndTheSmallestShiftDecides) {
  for (const bool aligned_first : {false, true}) {
    const std::pair<int, int> aligned = aligned_first ? std::pair(0, 1) : std::pair(2, 3);
    const std::pair<int, int> other = aligned_first ? std::pair(2, 3) : std::pair(0, 1);
    EXPECT_EQ(first_pair(timed(two_pairs(-11, aligned_first), Timing::certified)), std::pair(0, 1));
    EXPECT_EQ(first_pair(timed(two_pairs(-11 - 0x1p-40, aligned_first), Timing::certified)), other);
    EXPECT_EQ(first_pair(timed(two_pairs(-11 + 0x1p-40, aligned_first), Timing::certified)), aligned);
  }
  EXPECT_GT(timed(two_pairs(-11, false), Timing::certified).summary.certified->order.exact, 0U);
}

/// The oblique pair's event and an impulse on somebody else, at the double that its time rounds to.
Scene impulse_scene(const NearTie& tie) {
  Scene scene = testing::plain_scene();
  testing::block(scene, 0, 0);
  add_particle(scene, 0, {0, 0, 0});
  add_particle(scene, 0, {3, tie.offset, 0}, {-1, 0, 0});
  add_particle(scene, 0, {0, 100, 0});
  scene.impulses = {{.at = tie.t, .particle = 2, .impulse = {0, 1, 0}}};
  return scene;
}

TEST(Ties, RankDecidesOnlyExactTies) {
  for (const NearTie& tie : kNearTies) {
    const Scene scene = impulse_scene(tie);
    EXPECT_EQ(timed(scene, Timing::stable).events.at(0).kind, "scheduled_impulse") << tie.offset;
    EXPECT_EQ(timed(scene, Timing::certified).events.at(0).kind,
              tie.oblique_first ? "rebound" : "scheduled_impulse");
  }
  Scene exact = two_pairs(-11, false);
  exact.impulses = {{.at = 6, .particle = 3, .impulse = {0, 1, 0}}};
  EXPECT_EQ(timed(exact, Timing::certified).events.at(0).kind, "scheduled_impulse");
}

/// The pair (0, 1) starts to close at 2^-60, so that its computed time is t + 2^-60; its exact one is below t
/// by nearly half an ulp, and the pair (2, 3) meets at exactly t.
Scene later_but_earlier(const NearTie& tie) {
  Scene scene = testing::plain_scene();
  testing::block(scene, 0, 0);
  add_particle(scene, 0, {0, 0, 0});
  add_particle(scene, 0, {3, tie.offset, 0});
  add_particle(scene, 0, {0, 100, 0});
  add_particle(scene, 0, {1 + tie.t, 100, 0}, {-1, 0, 0});
  scene.impulses = {{.at = 0x1p-60, .particle = 1, .impulse = {-1, 0, 0}}};
  return scene;
}

TEST(Ties, TheClockWaitsForAnEventThatWasComputedTooEarly) {
  const Scene scene = later_but_earlier(kNearTies[0]);
  const TracedRun stable = timed(scene, Timing::stable);
  EXPECT_EQ(stable.events.at(1).i, 2);
  const TracedRun certified = timed(scene, Timing::certified);
  ASSERT_EQ(certified.events.size(), 3U);
  EXPECT_EQ(certified.events[1].i, 0);
  EXPECT_EQ(certified.events[2].i, 2);
  EXPECT_EQ(certified.events[2].exact_t, certified.events[1].exact_t);
  EXPECT_EQ(certified.events[2].exact_dt, "0x0p+0");
}

/// The pair (0, 1) starts to close at 2^-60 and needs 1 − 2^-60, which rounds to 1: computed at 1 + 2^-60, in
/// fact at 1 like the pair (2, 3).
Scene tie_computed_apart() {
  Scene scene = testing::plain_scene();
  testing::block(scene, 0, 0);
  add_particle(scene, 0, {0x1p-60, 0, 0});
  add_particle(scene, 0, {2, 0, 0});
  add_particle(scene, 0, {0, 100, 0});
  add_particle(scene, 0, {2, 100, 0}, {-1, 0, 0});
  scene.impulses = {{.at = 0x1p-60, .particle = 1, .impulse = {-1, 0, 0}}};
  return scene;
}

TEST(Ties, AnExactTieThatWasComputedApartGoesByIds) {
  EXPECT_EQ(timed(tie_computed_apart(), Timing::stable).events.at(1).i, 2);
  EXPECT_EQ(timed(tie_computed_apart(), Timing::certified).events.at(1).i, 0);
}

TEST(Ties, ARunCutAtAnyEventGoesOnToTheSameBytes) {
  std::vector<Scene> scenes = {later_but_earlier(kNearTies[0]), two_pairs(-11, true), tie_computed_apart()};
  for (const NearTie& tie : kNearTies) {
    scenes.push_back(near_tie_scene(tie));
    scenes.push_back(impulse_scene(tie));
  }
  for (const Scene& scene : scenes) {
    const TracedRun whole = timed(scene, Timing::certified);
    for (std::uint64_t cut = 0; cut < whole.events.size(); ++cut) {
      certified::ExactTiming certifier;
      RunOptions options = testing::options_for("double", cut);
      options.timing = Timing::certified;
      options.certifier = &certifier;
      options.state_every = 1;
      options.trace = testing::scratch("cut.ndjson");
      run_scene(scene, options);
      options.max_events.reset();
      options.timing = Timing::stable;  // the file's counts
      resume_run(options.trace, options);
      EXPECT_EQ(testing::read_bytes(options.trace), whole.bytes) << cut;
    }
  }
}

}  // namespace
}  // namespace tps
