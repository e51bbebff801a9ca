// What a summary says of clusters: extents and velocities of what can move, sizes of all that hangs together.
#include <gtest/gtest.h>

#include <cmath>

#include "reference/run/run.hpp"
#include "reference/scene/read_scene.hpp"
#include "verify/scenes/two_anchors.hpp"

namespace tps {
namespace {

// A wall's mass is in no sum: infinite ones made every mean a NaN, and the run an error of ours.
TEST(Clusters, AWallCountsAndDoesNotWeigh) {
  const Scene scene = read_scene_text(
      R"({"tps":1,"dimension":2,"duration":1,"species":{"a":{"mass":2,"radius":0.5},"w":{"mass":"inf","radius":0.5}},
          "pairs":[{"between":["a","w"],"tethering":{"distance":2,"c_retract":1,"c_revolve":1,"theta_revolve_deg":30}},
                   {"between":["a","a"],"tethering":{"distance":9,"c_retract":1,"c_revolve":1,"theta_revolve_deg":30}}],
          "particles":[{"species":"a","position":[0,0],"velocity":[0.5,0]},{"species":"a","position":[0,4],"velocity":[0.5,0]},
                       {"species":"w","position":[1.5,0]}],
          "tethers":[[0,1],[0,2]],"observe":{"clusters":{"species":"a","at_least":1}}})",
      "scene");
  const RunSummary run = run_scene(scene, {});
  ASSERT_FALSE(run.clusters.empty());
  const ClusterSample& first = run.clusters.front();
  EXPECT_EQ(first.sizes, std::vector<int>{2});
  EXPECT_EQ(first.particles, 3);
  EXPECT_EQ(first.mass, 4);
  EXPECT_EQ(first.extent, 2);
  EXPECT_EQ(first.centre_speed, 0.5);
}

TEST(Clusters, OfWallsAloneHaveNoMotion) {
  Scene scene = build_two_anchors({});
  scene.clusters = ClusterObservation{scene.particles.back().species, 1};
  for (int species = 0; species < static_cast<int>(scene.species.size()); ++species) {
    scene.clusters->species = species;
    const RunSummary run = run_scene(scene, {});
    for (const ClusterSample& sample : run.clusters)
      EXPECT_TRUE(std::isfinite(sample.extent + sample.mass + sample.centre_speed)) << species;
  }
}

}  // namespace
}  // namespace tps
