// Grouping at scale: bodies that merge pair by pair until one group holds them all.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/run/traced_run.hpp"
#include "verify/certified/exact_timing.hpp"

namespace tps {
namespace {

/// 2^levels balls of diameter 1 in a row. Two neighbours collide, then two pairs, and so on: the halves of a
/// block approach each other with speed 1 from gaps that treble from level to level, so that each half is one
/// body by the time. Gaps differ by up to a hundredth, so that no two collisions are simultaneous.
class MergingRow {
 public:
  explicit MergingRow(int levels) : gap_(std::pow(3., -levels)) {
    scene_ = testing::plain_scene();
    testing::block(scene_, 0, 0, 1);
    add(levels, 0, 0);
    scene_.grouping = Grouping{8};
    scene_.duration = 20;
  }
  const Scene& scene() const { return scene_; }

 private:
  /// @return where the block ends.
  double add(int level, double x, double v) {
    if (level == 0) {
      testing::add_particle(scene_, 0, {x + .5, 0, 0}, {v, 0, 0});
      return x + 1;
    }
    const double middle = add(level - 1, x, v + .5);
    const double gap = gap_ * std::pow(3., level) * (1 + 0.01 * static_cast<double>(random_() % 1024) / 1024);
    return add(level - 1, middle + gap, v - .5);
  }

  Scene scene_;
  double gap_;
  std::mt19937 random_{1};
};

RunSummary run(int levels) {
  const MergingRow row(levels);
  certified::ExactTiming certifier;
  RunOptions options;
  options.max_events =
      2 * (row.scene().particles.size() - 1);  // loads, nodes; then all are in contact at once
  options.timing = Timing::certified;
  options.certifier = &certifier;
  return run_scene(row.scene(), options);
}

/// One group of them all, and its restitution, a node at a time. The members of a group are not asked about
/// each other: questions grow with the particles, not with their squares or the sizes of their groups.
TEST(LargeGroup, SixteenThousandMergeAndPartAtTheCostOfTheirNeighbours) {
  constexpr int kFew = 11, kMany = 14;
  const RunSummary few = run(kFew), many = run(kMany);
  for (const auto& [s, levels] : {std::pair(&few, kFew), std::pair(&many, kMany)}) {
    const std::uint64_t n = std::uint64_t{1} << static_cast<unsigned>(levels);
    EXPECT_EQ(s->largest_group, n);
    EXPECT_EQ(s->live_groups, 0U);
    EXPECT_EQ(s->by_kind.at("rebound"), n - 1);
    EXPECT_EQ(s->by_kind.at("restitute"), n - 1);
    EXPECT_LE(std::abs(s->energy_remainder), s->energy_bound);
    EXPECT_LE(s->momentum_drift, s->momentum_bound);
  }
  // Each level of merging touches every particle once more, and makes the fastest faster. Whole groups would
  // make it 64 times as many.
  const double levels = double(kMany) / kFew;
  const auto questions = [](const RunSummary& s) { return double(s.certified->verdict.calls); };
  EXPECT_LE(questions(many), 2 * levels * (1 << (kMany - kFew)) * questions(few));
}

}  // namespace
}  // namespace tps
