// What the explanation of a scene says of why an effect is simulated.
#include "reference/run/explain.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/run/traced_run.hpp"

namespace tps {
namespace {

TEST(Explain, SaysOnWhichSideOfAWallParticlesAre) {
  Scene scene = testing::plain_scene(2);
  for (const Wall::Shape shape : {Wall::Shape::plane, Wall::Shape::sphere, Wall::Shape::box}) {
    for (const bool inside : {true, false}) {
      Wall wall;
      wall.shape = shape;
      wall.inside = inside;
      scene.walls.push_back(wall);
    }
  }
  const std::vector<EffectCall> calls = explain(scene).effects;
  const auto walls = std::ranges::find(calls, "walls", &EffectCall::name);
  std::vector<std::string> places;
  for (const CallingPlace& place : walls->because) places.push_back(place.what);
  EXPECT_EQ(walls->because.back().pointer, "/walls/5");
  EXPECT_EQ(places, (std::vector<std::string>{"wall 0 (plane)", "wall 1 (plane)",
                                              "wall 2 (inside of a sphere)", "wall 3 (outside of a sphere)",
                                              "wall 4 (inside of a box)", "wall 5 (outside of a box)"}));
}

}  // namespace
}  // namespace tps
