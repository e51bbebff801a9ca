// Scenes that must be accepted, and that survive being written and read again.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "reference/scene/read_scene.hpp"
#include "reference/scene/write_scene.hpp"

namespace tps {
namespace {

const std::filesystem::path good_folder = std::filesystem::path(TPS_SOURCE_DIR) / "tests/scene/good";

Scene good(const std::string& name) {
  return read_scene_file((good_folder / (name + ".json")).string());
}

std::vector<std::string> good_names() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(good_folder)) {
    if (entry.path().extension() == ".json") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

class GoodScene : public testing::TestWithParam<std::string> {};

TEST_P(GoodScene, IsTheSameAfterBeingWrittenAndRead) {
  const Scene scene = good(GetParam());
  EXPECT_EQ(read_scene_text(write_scene(scene, SceneStyle::compact), "compact"), scene);
  EXPECT_EQ(read_scene_text(write_scene(scene, SceneStyle::pretty), "pretty"), scene);
}

TEST_P(GoodScene, CompactStyleIsOneLine) {
  const std::string text = write_scene(good(GetParam()), SceneStyle::compact);
  EXPECT_EQ(text.find('\n'), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Files, GoodScene, testing::ValuesIn(good_names()),
                         [](const auto& parameter) { return parameter.param; });

TEST(ReadScene, TakesEveryKey) {
  const Scene scene = good("everything");
  EXPECT_EQ(scene.title, "every key of the format once");
  EXPECT_EQ(scene.dimension, 3);
  EXPECT_EQ(scene.duration, std::numeric_limits<double>::infinity());
  EXPECT_EQ(scene.start_time, 0x1p40);
  EXPECT_EQ(scene.seed, 0xfeedfacecafebeefU);

  ASSERT_EQ(scene.species.size(), 3U);
  EXPECT_EQ(scene.species[0], (Species{"vesicle", 1, 0.5, 4}));
  EXPECT_EQ(scene.species[1], (Species{"synapsin", 0.125, 0.125, std::nullopt}));
  EXPECT_EQ(scene.species[2],
            (Species{"membrane", std::numeric_limits<double>::infinity(), 10, std::nullopt}));

  ASSERT_EQ(scene.pairs.size(), 3U);
  EXPECT_EQ(scene.pairs[0], (PairLaw{0, 0, BlockingLaw{1.5, 0.9}, std::nullopt}));
  const TetheringLaw tethering = {
      1.25, 0.9, 0.8, 45, {FormRule::When::probability, 0.5}, {BreakRule::When::impulse_above, 0, 3}};
  EXPECT_EQ(scene.pairs[1], (PairLaw{0, 1, BlockingLaw{0.625, 1}, tethering}))
      << "distance: sum of the radii";
  const TetheringLaw membrane = {9.5, 1, 1, 30, {FormRule::When::permanent, 1}, {}};
  EXPECT_EQ(scene.pairs[2], (PairLaw{0, 2, std::nullopt, membrane})) << "distance: difference of the radii";

  EXPECT_EQ(scene.grouping, Grouping{0.001});
  ASSERT_EQ(scene.phases.size(), 3U);
  EXPECT_EQ(scene.phases[0], (Phase{1, 2, 0, 1, FormRule{FormRule::When::never, 1}, std::nullopt}));
  EXPECT_EQ(scene.phases[1], (Phase{1, std::numeric_limits<double>::infinity(), 0, 1, std::nullopt,
                                    BreakRule{BreakRule::When::probability, 0.125, 0}}));

  ASSERT_EQ(scene.particles.size(), 3U);
  EXPECT_EQ(scene.particles[0].id, 2) << "sorted by id; the default id is the place in the list";
  EXPECT_EQ(scene.particles[0].velocity, (Coordinates{-0.75, 0, 0}));
  EXPECT_TRUE(std::signbit(scene.particles[0].velocity[2])) << "-0.0 keeps its sign";
  EXPECT_EQ(scene.particles[1], (Particle{7, 0, {0.1, 0, 0}, {1, -2, 3e-3}}));
  EXPECT_EQ(scene.particles[2], (Particle{9, 2, {0, 0, 0}, {0, 0, 0}})) << "the default velocity is zero";

  ASSERT_EQ(scene.impulses.size(), 1U);
  EXPECT_EQ(scene.impulses[0], (ScheduledImpulse{2.5, 1, {0, 0, 10}})) << "by index, not by id";
  EXPECT_EQ(scene.tethers, (std::vector<Tether>{{0, 1}}));
  EXPECT_EQ(scene.clusters, (ClusterObservation{0, 2}));
}

TEST(ReadScene, FillsInDefaults) {
  const Scene scene = good("smallest");
  Scene expected;
  expected.dimension = 2;
  expected.duration = 1;
  expected.species = {{"ball", 1, 0, std::nullopt}};
  expected.particles = {Particle{}};
  EXPECT_EQ(scene, expected);
}

}  // namespace
}  // namespace tps
