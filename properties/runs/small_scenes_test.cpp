// The generator of scenes: what it makes is valid, small, and meets what it aims at.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <iostream>
#include <map>

#include "properties/runs/hazards.hpp"
#include "properties/runs/scenes.hpp"
#include "reference/scene/read_scene.hpp"
#include "reference/scene/write_scene.hpp"

namespace tps::properties::runs {
namespace {

RC_GTEST_PROP(SmallScenes, AreValid, ()) {
  const Scene scene = (*small_scene()).scene;
  RC_ASSERT(read_scene_text(write_scene(scene), "generated") == scene);
}

/// Scenes by RapidCheck's own generator of random numbers, from a fixed seed.
std::vector<Scene> sample(int count) {
  std::vector<Scene> scenes;
  rc::Random random(20260101);
  for (int n = 0; n < count; ++n) scenes.push_back(small_scene()(random.split(), 100).value().scene);
  return scenes;
}

TEST(SmallScenes, MeetTheirHazards) {
  constexpr int kScenes = 1000;
  const auto simulator = reference_simulator("double", "stable");
  std::map<std::string, int> count;
  for (const Scene& scene : sample(kScenes)) {
    for (const std::string& hazard : hazards_met(scene, simulator->run(scene))) ++count[hazard];
  }
  for (const HazardFloor& floor : hazard_floors()) {
    std::cout << floor.name << ": " << count[floor.name] << " of " << kScenes << ", at least "
              << floor.in_a_thousand << "\n";
    EXPECT_GE(count[floor.name], floor.in_a_thousand) << floor.name << ": " << floor.meaning;
  }
}

TEST(SmallScenes, ShrinkToTwoParticlesOfOneSpecies) {
  rc::Random random(20260101);
  auto shrinkable = small_scene()(random, 100);
  while (const auto smaller = shrinkable.shrinks().next()) shrinkable = *smaller;
  const Scene scene = shrinkable.value().scene;
  EXPECT_EQ(scene.particles.size(), 2U);
  EXPECT_EQ(scene.species.size(), 1U);
  EXPECT_EQ(scene.particles.front().velocity, Coordinates{});
  EXPECT_EQ(scene.duration, 1);
  EXPECT_TRUE(scene.impulses.empty() && scene.phases.empty() && !scene.grouping);
}

}  // namespace
}  // namespace tps::properties::runs
