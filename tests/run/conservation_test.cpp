// The ledger closes, momentum stays within its bound and distances within rounding, for every scene that
// `tps scene` writes.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "reference/scene/read_scene.hpp"
#include "tests/run/traced_run.hpp"
#include "verify/scenes/galperin.hpp"
#include "verify/scenes/registry.hpp"

namespace tps {
namespace {

using testing::options_for;

/// The scenes at their defaults, the large ones with fewer particles.
Scene catalogue_scene(const SceneBuilder& builder) {
  if (builder.name == "terminal")
    return builder.build(
        {{"vesicles", "10"}, {"pairs", "20"}, {"membrane-radius", "14"}, {"impact-at", "1"}});
  if (builder.name == "gas") return builder.build({{"particles", "40"}});
  if (builder.name == "sheet") return builder.build({{"rows", "5"}, {"columns", "5"}});
  return builder.build({});
}

class Catalogue : public ::testing::TestWithParam<std::string> {};

void expect_conserved(const RunSummary& s, double most_inside = 8) {
  EXPECT_GT(s.events, 0U);
  EXPECT_LE(std::abs(s.energy_remainder), s.energy_bound) << s.scalar;
  EXPECT_LE(s.momentum_drift, s.momentum_bound) << s.scalar;
  // Landing at an event at distance L: the time has a relative error of a few u, which moves both particles
  // by that part of a free path; paths are at most the size of the scene, that is of the largest coordinates.
  // Each coordinate of both is then rounded once: √d ulps in all. 8 is twice the sum for the few u counted
  // as 2.
  EXPECT_LE(s.worst_inner_excess, most_inside) << s.scalar;
  EXPECT_LE(s.worst_outer_excess, 8) << s.scalar;
}

TEST_P(Catalogue, ConservesWithinBounds) {
  const Scene scene = catalogue_scene(scene_builder(GetParam()));
  for (const char* scalar : {"double", "float"}) {
    RunOptions options = options_for(scalar, 3000);
    expect_conserved(run_scene(scene, options));
  }
}

TEST_P(Catalogue, RunsInFiftyDigits) {
  const Scene scene = catalogue_scene(scene_builder(GetParam()));
  const RunSummary s = run_scene(scene, options_for("mp50", 150));
  if (GetParam() != "two-anchors") {
    EXPECT_NE(s.end, "stalled");
  }
  // The cradle's balls touch but for the rounding of 0.1·i in double, of which up to 4 ulps are accepted; in
  // ulps of fifty digits (168 bits) that overlap is large, and it is the scene's.
  expect_conserved(s, GetParam() == "cradle" ? std::ldexp(4, 168 - 53) : 8);
  // Fifty digits leave nothing that a double could show.
  EXPECT_LE(std::abs(s.energy_remainder), 1e-40 * (s.kinetic_at_start + s.work));
}

std::vector<std::string> names() {
  std::vector<std::string> all;
  for (const SceneBuilder& builder : scene_builders()) all.push_back(builder.name);
  return all;
}
INSTANTIATE_TEST_SUITE_P(All, Catalogue, ::testing::ValuesIn(names()), [](const auto& scene) {
  std::string name = scene.param;
  std::erase(name, '-');
  return name;
});

// The heavy ball's velocity does not change by one light hit: its momentum is below the ball's rounding. The
// bound has to count events that rounding erased.
// The sums round what no event touched: a ball of mass 7 that flies by, beside one of 1e-9 at a wall.
TEST(Conservation, BoundCoversTheSumsOfBystanders) {
  const Scene scene = read_scene_file(TPS_SOURCE_DIR "/tests/run/light_beside_heavy.json");
  const RunSummary s = run_scene(scene, options_for("double"));
  EXPECT_GT(s.events, 0U);
  EXPECT_LE(std::abs(s.energy_remainder), s.energy_bound);
  EXPECT_LE(s.momentum_drift, s.momentum_bound);
}

TEST(Conservation, BoundCoversImpulsesThatRoundingErases) {
  Scene scene = build_galperin({.digits = 9});
  const RunSummary s = run_scene(scene, options_for("double", 2000));
  EXPECT_LE(s.momentum_drift, s.momentum_bound);
  EXPECT_LE(std::abs(s.energy_remainder), s.energy_bound);
}

}  // namespace
}  // namespace tps
