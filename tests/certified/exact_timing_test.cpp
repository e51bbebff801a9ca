// Certified answers as a run receives them: verdicts at edges, times rounded once, for float too.
#include "verify/certified/exact_timing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <compare>

#include "reference/engine/pair_timing.hpp"
#include "tests/run/traced_run.hpp"

namespace tps {
namespace {

using certified::ExactTiming;

template <typename Scalar>
PairView<Scalar, 2> relative(Vector<Scalar, 2> r, Vector<Scalar, 2> v) {
  const Vector<Scalar, 2> zero = Vector<Scalar, 2>::Zero();
  return {0, 1, {}, zero, r, zero, v};
}

/// u_B − u_A is 1 − 2^-60 in y, which rounds to the limit 1: in double it is a touch.
Scene hidden_graze() {
  Scene scene = testing::plain_scene();
  testing::block(scene, 0, 0);
  testing::add_particle(scene, 0, {0, 0x1p-60, 0});
  testing::add_particle(scene, 0, {-3, 1, 0}, {1, 0, 0});
  return scene;
}

/// From ten thousand away, past the limit at 1 − 2^-30: the printed discriminant is 0.
Scene distant_graze() {
  Scene scene = testing::plain_scene();
  testing::block(scene, 0, 0);
  testing::add_particle(scene, 0, {0, 0, 0});
  testing::add_particle(scene, 0, {-1e4, 1 - 0x1p-30, 0}, {1, 0, 0});
  return scene;
}

std::uint64_t events_of(const Scene& scene, Timing timing) {
  ExactTiming certifier;
  RunOptions options;
  options.timing = timing;
  options.certifier = &certifier;
  return run_scene(scene, options).events;
}

TEST(ExactTiming, SeesACollisionThatRoundedDifferencesHide) {
  EXPECT_EQ(events_of(hidden_graze(), Timing::paper), 0U);
  EXPECT_EQ(events_of(hidden_graze(), Timing::stable), 0U);
  EXPECT_EQ(events_of(hidden_graze(), Timing::certified), 1U);
}

TEST(ExactTiming, SeesWithTheStableFormulaACollisionThatThePrintedOneMisses) {
  EXPECT_EQ(events_of(distant_graze(), Timing::paper), 0U);
  EXPECT_EQ(events_of(distant_graze(), Timing::stable), 1U);
  EXPECT_EQ(events_of(distant_graze(), Timing::certified), 1U);
}

// 16777215 + √(1/4 − 2^-60) is below the middle of two floats by 2^-60, which a double does not show;
// rounding the double would go to the even one above.
TEST(ExactTiming, RoundsOnceToFloat) {
  ExactTiming certifier;
  const PairTiming<float, 2> timing({Timing::certified, &certifier});
  const auto time = [&](float x, float y, TimingKind kind) {
    return *timing.next(relative<float>({-x, y}, {1, 0}), {kind, .5F, false});
  };
  EXPECT_EQ(time(16777215, 0x1p-30F, TimingKind::tether), 16777215.F);
  EXPECT_EQ(time(16777215, 0, TimingKind::tether), 16777216.F) << "an exact tie goes to the even one";
  EXPECT_EQ(time(16777213, 0x1p-30F, TimingKind::block), 16777213.F) << "above the middle of …12 and …13";
  EXPECT_EQ(time(16777213, 0, TimingKind::block), 16777212.F);
  EXPECT_EQ(time(3, 0, TimingKind::block), 2.5F);
}

TEST(ExactTiming, AnswersLikeTheStableFormulaWhereNothingRounds) {
  ExactTiming certifier;
  const PairTiming<double, 2> certified({Timing::certified, &certifier});
  const PairTiming<double, 2> stable({});
  int events = 0;
  for (const Vector<double, 2>& r :
       {Vector<double, 2>(-10, 3), Vector<double, 2>(-6, 8), Vector<double, 2>(5, 0),
        Vector<double, 2>(-4, 3), Vector<double, 2>(-1, 0), Vector<double, 2>(0, 5)}) {
    for (const bool responded : {false, true}) {
      for (const TimingKind kind : {TimingKind::block, TimingKind::tether}) {
        const auto pair = relative<double>(r, {1, 0});
        const auto t = certified.next(pair, {kind, 5, responded});
        EXPECT_EQ(t, stable.next(pair, {kind, 5, responded}));
        events += t ? 1 : 0;
      }
    }
  }
  EXPECT_GT(events, 12);
}

// After a response `turning` stands for c = 0: twice the time, in prediction and in order.
TEST(ExactTiming, APairTakenToBeAtItsLimitHasTwiceTheTime) {
  ExactTiming certifier;
  const PairTiming<double, 2> timing({Timing::certified, &certifier});
  const auto pair = relative<double>({-6, 8}, {1, 0});
  const LimitQuestion<double> fresh{TimingKind::tether, 7, false};
  const LimitQuestion<double> responded{TimingKind::tether, 7, true};
  EXPECT_EQ(timing.next(pair, fresh), 6.);
  EXPECT_EQ(timing.next(pair, responded), 12.);
  EXPECT_TRUE(std::is_eq(timing.order(timing.moment(pair, responded), timing.known({12, 0}))));
  EXPECT_TRUE(std::is_eq(timing.order(timing.moment(pair, fresh), timing.known({6, 0}))));
}

TEST(ExactTiming, NumbersThatLeftTheRangeHaveNoEvent) {
  ExactTiming certifier;
  const PairTiming<double, 2> timing({Timing::certified, &certifier});
  for (const double x : {HUGE_VAL, std::nan("")}) {
    EXPECT_FALSE(timing.next(relative<double>({x, 0}, {1, 0}), {TimingKind::block, 1, false}));
    EXPECT_FALSE(timing.next(relative<double>({1, 0}, {0, x}), {TimingKind::tether, 1, false}));
  }
}

TEST(ExactTiming, IsRefusedForOtherScalarsAndWithoutACertifier) {
  ExactTiming certifier;
  const TimingChoice choice{Timing::certified, &certifier};
  EXPECT_THROW((PairTiming<long double, 2>(choice)), std::invalid_argument);
  EXPECT_THROW((PairTiming<double, 2>({Timing::certified, nullptr})), std::invalid_argument);
}

}  // namespace
}  // namespace tps
