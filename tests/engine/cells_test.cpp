// The parts of the cells detector, each against a search through everything.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <set>

#include "reference/engine/cells/outlook.hpp"
#include "reference/engine/cells/particle_queue.hpp"
#include "reference/engine/cells/region_grid.hpp"
#include "reference/engine/cells/region_plan.hpp"
#include "reference/engine/cells/region_width.hpp"
#include "reference/scene/read_scene.hpp"

namespace tps {
namespace {

class Choices {
 public:
  explicit Choices(std::uint64_t seed) : bits_(seed) {}
  int whole(int low, int high) {
    return low + static_cast<int>(bits_() % static_cast<std::uint64_t>(high - low + 1));
  }

 private:
  std::mt19937_64 bits_;
};

Region<3> region_in(Choices& choices, int extent) {
  Region<3> region{};
  for (std::int32_t& x : region) x = choices.whole(-extent, extent);
  return region;
}

/// Buckets of every width, ranges that are wider than the whole grid, particles that come and go.
TEST(RegionGrid, ASearchFindsWhoIsInTheRangeAndWantedAndNobodyTwice) {
  Choices choices(1);
  for (int round = 0; round < 60; ++round) {
    const int extent = choices.whole(0, 40);
    FiledRegions<3> filed(static_cast<std::size_t>(choices.whole(1, 60)));
    std::vector<int> members;
    for (std::size_t i = 0; i < filed.size(); ++i) {
      filed[i].region = region_in(choices, extent);
      members.push_back(static_cast<int>(i));
    }
    RegionGrid<3> grid;
    grid.build(members, choices.whole(0, 3), filed);
    for (int step = 0; step < 20; ++step) {
      const int moved = choices.whole(0, static_cast<int>(filed.size()) - 1);
      grid.remove(moved, filed);
      filed[static_cast<std::size_t>(moved)].region = region_in(choices, 2 * extent);
      grid.file(moved, filed);
      RegionRange<3> range{region_in(choices, extent), {}};
      for (std::size_t k = 0; k < 3; ++k) range.high[k] = range.low[k] + choices.whole(0, extent);
      std::vector<int> heads, found, expected;
      const auto is_even = [](int j, const Region<3>&) { return j % 2 == 0; };
      grid.search(range, filed, is_even, heads, found);
      const auto is_in = [&](int j) {
        return j % 2 == 0 && range.contains(filed[static_cast<std::size_t>(j)].region);
      };
      std::copy_if(members.begin(), members.end(), std::back_inserter(expected), is_in);
      std::sort(found.begin(), found.end());
      EXPECT_EQ(std::adjacent_find(found.begin(), found.end()), found.end());
      EXPECT_EQ(found, expected);
    }
  }
}

/// Times of a run: what is due is put off, others are brought forward, and some never come.
template <typename Scalar>
struct DueTimes {
  explicit DueTimes(std::uint32_t seed) : choices(seed) {}

  Time<Scalar> next(const Time<Scalar>& now, int kind) {
    if (choices.whole(0, 19) == 0) return Time<Scalar>::never();
    const double u = choices.whole(1, 1000) / 1000.0;
    switch (kind) {
      case 0:
        return {Scalar(choices.whole(0, 30)), Scalar(choices.whole(-1, 1) * 0x1p-60)};  // ties
      case 1:
        return after(now, Scalar(-std::log(u)));  // a gas
      case 2:
        return after(now, Scalar(std::ldexp(u, choices.whole(-100, 100))));  // all scales
      case 3:
        return after(now, Scalar(choices.whole(0, 9) == 0 ? u : 0x1p-30 * u));  // a burst
      default:
        return {std::numeric_limits<Scalar>::max() / Scalar(choices.whole(1, 3)), Scalar(0)};
    }
  }
  Choices choices;
};

template <typename Scalar>
void expect_a_sorted_list(int particles, int steps, int kind) {
  DueTimes<Scalar> times(static_cast<std::uint32_t>(kind + particles));
  ParticleQueue<Scalar> queue;
  queue.reset(static_cast<std::size_t>(particles));
  std::vector<Time<Scalar>> due(static_cast<std::size_t>(particles), Time<Scalar>::never());
  const auto near = [](const std::vector<int>&) {};
  Time<Scalar> now;
  const auto schedule = [&](int i) {
    due[static_cast<std::size_t>(i)] = times.next(now, kind);
    queue.schedule(i, due[static_cast<std::size_t>(i)]);
  };
  for (int i = 0; i < particles; ++i) schedule(i);
  for (int step = 0; step < steps; ++step) {
    const auto first = queue.earliest(near);
    ASSERT_EQ(first.time, *std::min_element(due.begin(), due.end())) << kind;
    ASSERT_EQ(due[static_cast<std::size_t>(first.particle)], first.time);
    if (first.time < Time<Scalar>::never()) now = std::max(now, first.time);
    const Time<Scalar> latest = times.choices.whole(0, 1) == 0 ? now : times.next(now, kind);
    std::vector<int> found, expected;
    queue.due_until(latest, found, near);
    for (int j = 0; j < particles; ++j) {
      if (due[static_cast<std::size_t>(j)] <= latest) expected.push_back(j);
    }
    std::sort(found.begin(), found.end());
    ASSERT_EQ(found, expected) << kind;
    schedule(first.particle);
    for (int n = times.choices.whole(0, 4); n > 0; --n) schedule(times.choices.whole(0, particles - 1));
  }
}

TEST(ParticleQueue, TheEarliestAndAllUpToATimeAreThoseOfASortedList) {
  for (int kind = 0; kind < 5; ++kind) {
    expect_a_sorted_list<double>(40, 2000, kind);
    expect_a_sorted_list<double>(1500, 3000, kind);
    expect_a_sorted_list<float>(700, 500, kind);
    expect_a_sorted_list<long double>(700, 500, kind);
  }
}

/// The law of an outlook: what was added is in it, or at or after complete_until().
TEST(Outlook, NothingThatWasAddedIsBeforeTheEndOfWhatItKnowsAndNotInIt) {
  Choices choices(3);
  for (int round = 0; round < 300; ++round) {
    Outlook<double> outlook;
    std::vector<std::pair<Time<double>, int>> added;
    for (int partner = 0; partner < choices.whole(1, 8); ++partner) {
      const Time<double> time{double(choices.whole(0, 6)), 0};
      outlook.add(time, {partner, 0, 0});
      added.emplace_back(time, partner);
    }
    std::set<int> held;
    for (int n = 0; n < outlook.count(); ++n) {
      held.insert(outlook.partner(n).particle);
      EXPECT_LE(outlook.time(std::max(n - 1, 0)), outlook.time(n));
    }
    for (const auto& [time, partner] : added) {
      EXPECT_TRUE(held.contains(partner) || outlook.complete_until() <= time) << partner;
    }
    EXPECT_EQ(outlook.due(), std::min_element(added.begin(), added.end())->first);
  }
}

TEST(Outlook, ASecondMeetingWithAPartnerReplacesTheFirst) {
  Outlook<double> outlook;
  outlook.add({1, 0}, {7, 0, 0});
  outlook.add({2, 0}, {7, 1, 0});
  ASSERT_EQ(outlook.count(), 1);
  EXPECT_EQ(outlook.time(0).hi, 2);
  EXPECT_EQ(outlook.partner(0).revision, 1U);
}

TEST(RegionPlan, LargeAndSmallSpeciesHaveLevelsOfTheirOwnAndContainersNoNeighbours) {
  const Scene scene = read_scene_text(
      R"({"tps":1,"dimension":3,"duration":1,
          "species":{"wall":{"mass":"inf","radius":5000},"large":{"mass":9,"radius":500},"small":{"mass":1,"radius":0.5}},
          "pairs":[{"between":["wall","small"],"tethering":{"distance":4999,"c_retract":1,"c_revolve":1,
                    "theta_revolve_deg":45,"form":"permanent","break":"never"}},
                   {"between":["large","small"],"blocking":{"c_rebound":1}},
                   {"between":["small","small"],"blocking":{"c_rebound":1}}],
          "particles":[{"id":0,"species":"wall","position":[0,0,0],"velocity":[0,0,0]},
                       {"id":1,"species":"large","position":[0,0,0],"velocity":[0,0,0]},
                       {"id":2,"species":"small","position":[600,0,0],"velocity":[1,0,0]},
                       {"id":3,"species":"small","position":[700,0,0],"velocity":[1,0,0]}]})",
      "test");
  const RegionPlan plan = RegionPlan::of<double>(scene, {});
  const auto species = [&](const char* name) {
    const auto at = std::find_if(scene.species.begin(), scene.species.end(),
                                 [&](const Species& s) { return s.name == name; });
    return static_cast<int>(at - scene.species.begin());
  };
  const int wall = plan.level(species("wall"));
  const int large = plan.level(species("large"));
  const int small = plan.level(species("small"));
  EXPECT_EQ((std::set<int>{wall, large, small}.size()), 3U);
  EXPECT_LT(plan.reach(species("small"), small), 1.1);
  EXPECT_NEAR(plan.reach(species("small"), large), 500.5, 0.1);
  EXPECT_LT(plan.reach(species("small"), wall), 0);
  EXPECT_LT(plan.reach(species("large"), large), 0);
  ASSERT_EQ(plan.permanent(species("small")).size(), 1U);
  EXPECT_LT(plan.permanent(species("small"))[0].far, 4999);
}

/// A float has 24 bits: at 10⁶ a margin of 1/64 is less than its last one.
TEST(RegionPlan, WhatRoundingMovesByMoreThanTheMarginIsNotKept) {
  const Scene scene = read_scene_text(
      R"({"tps":1,"dimension":2,"duration":1,"species":{"p":{"mass":1,"radius":0.5}},
          "pairs":[{"between":["p","p"],"blocking":{"c_rebound":1}}],
          "particles":[{"id":0,"species":"p","position":[0,0],"velocity":[0,0]},
                       {"id":1,"species":"p","position":[2,0],"velocity":[0,0]}]})",
      "test");
  EXPECT_TRUE(RegionPlan::of<double>(scene, {}).keeps(1e6, 1, 1, 1));
  EXPECT_FALSE(RegionPlan::of<float>(scene, {}).keeps(1e6, 1, 1, 1));
  EXPECT_TRUE(RegionPlan::of<float>(scene, {}).keeps(100, 1, 1, 1));
  EXPECT_FALSE(RegionPlan::of<float>(scene, {}).keeps(100, 1, 100, 1));
  EXPECT_FALSE(RegionPlan::of<double>(scene, {}).keeps(1, 1, 1, 1e40));
}

Scene two_in_a_box() {
  return read_scene_text(
      R"({"tps":1,"dimension":2,"duration":1,"species":{"p":{"mass":1,"radius":0.5}},
          "box":{"periodic":[100,40]},"pairs":[{"between":["p","p"],"blocking":{"c_rebound":1}}],
          "particles":[{"id":0,"species":"p","position":[0,0],"velocity":[0,0]},
                       {"id":1,"species":"p","position":[2,0],"velocity":[0,0]}]})",
      "test");
}

TEST(RegionPlan, RegionsGrowAsLongAsABoxHasRoomAndShrinkToWhatTheyWere) {
  const Scene scene = two_in_a_box();
  RegionPlan plan = RegionPlan::of<double>(scene, {});
  const RegionLevel before = plan.levels()[0];
  const double room = plan.longest_roam(*scene.box, 2);
  int grown = 0;
  while (plan.widen(0, scene.box, 2)) ++grown;
  EXPECT_EQ(grown, 3);  // .52 · 2³ < 19 / 3 · 63 / 64
  EXPECT_EQ(plan.levels()[0].side, 8 * before.side);
  EXPECT_GT(plan.longest_roam(*scene.box, 2), room / 3);
  while (plan.narrow(0)) --grown;
  EXPECT_EQ(grown, 0);
  EXPECT_EQ(plan.levels()[0].side, before.side);
  EXPECT_EQ(plan.levels()[0].shift, before.shift);
  EXPECT_EQ(plan.levels()[0].regions_within_reach, before.regions_within_reach);
  for (grown = 0; plan.widen(0, {}, 2); ++grown) ASSERT_LT(grown, 64);
}

TEST(RegionWidths, GrowWhereManyCrossAndFewAreFoundAndShrinkWhereManyAre) {
  enum class Advice { keep, widen, narrow };
  const auto advice = [](int crossings_per_touch, std::size_t found) {
    RegionWidths widths;
    widths.reset(10);
    for (int n = 0; n < 10000; ++n) {
      for (int k = 0; k < crossings_per_touch; ++k) {
        if (widths.crossed(0, found)) return Advice::widen;
      }
      if (widths.touched(0, found)) return Advice::narrow;
    }
    return Advice::keep;
  };
  EXPECT_EQ(advice(100, 1), Advice::widen);
  EXPECT_EQ(advice(100, 30), Advice::keep);
  EXPECT_EQ(advice(2, 1), Advice::keep);
  EXPECT_EQ(advice(2, 30), Advice::keep);
  EXPECT_EQ(advice(0, 100), Advice::narrow);
}

}  // namespace
}  // namespace tps
