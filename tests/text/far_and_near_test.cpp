// Starts are looked at through a tree of boxes; what it finds is what looking at every pair finds, in the
// same order.
#include <gtest/gtest.h>

#include <random>

#include "reference/scene/check_starts.hpp"
#include "reference/scene/point_tree.hpp"
#include "reference/scene/read_scene.hpp"
#include "tests/support/processor_time.hpp"

namespace tps {
namespace {

Scene with_particles(std::size_t count, std::mt19937& random) {
  Scene scene;
  scene.dimension = 3;
  scene.species = {{"A", 1, .5, {}}, {"B", 1, .5, {}}};
  // Many coordinates are equal, or whole: ties, flat boxes, distances that are exactly the limit.
  std::uniform_real_distribution<double> uniform(-10, 10);
  for (std::size_t n = 0; n < count; ++n) {
    Particle p{static_cast<std::int32_t>(n), static_cast<int>(random() % 2), {}, {}};
    for (double& x : p.position) x = random() % 2 == 0 ? static_cast<double>(random() % 7) : uniform(random);
    scene.particles.push_back(p);
  }
  return scene;
}

std::vector<std::size_t> all(const Scene& scene) {
  std::vector<std::size_t> indices(scene.particles.size());
  for (std::size_t k = 0; k < indices.size(); ++k) indices[k] = k;
  return indices;
}

TEST(PointTree, MissesNoPairThatIsNearerOrFarther) {
  std::mt19937 random(11);
  for (int round = 0; round < 300; ++round) {
    const Scene scene = with_particles(1 + random() % 60, random);
    const PointTree tree(scene, all(scene));
    const double limit = random() % 2 == 0 ? static_cast<double>(1 + random() % 12)
                                           : .3 + .01 * static_cast<double>(random() % 2000);
    for (const Particle& p : scene.particles) {
      std::vector<bool> near(scene.particles.size()), far(scene.particles.size());
      tree.visit([&](const auto& box) { return may_be_nearer(box, p.position, limit); },
                 [&](std::size_t k) { near[k] = true; });
      tree.visit([&](const auto& box) { return may_be_farther(box, p.position, limit); },
                 [&](std::size_t k) { far[k] = true; });
      for (std::size_t k = 0; k < scene.particles.size(); ++k) {
        const StartVerdict verdict = start_verdict(p.position, scene.particles[k].position, limit);
        EXPECT_TRUE(verdict != StartVerdict::nearer || near[k]);
        EXPECT_TRUE(verdict != StartVerdict::farther || far[k]);
      }
    }
  }
}

TEST(PointTree, IsSafeAtTheEndsOfTheRange) {
  constexpr double max = std::numeric_limits<double>::max();
  constexpr double tiny = std::numeric_limits<double>::denorm_min();
  const PointTree::Box wide{{-max, 0, 0}, {max, 0, 0}};
  EXPECT_TRUE(may_be_farther(wide, {max, 0, 0}, max));
  EXPECT_TRUE(may_be_nearer(wide, {0, 0, 0}, tiny));
  const PointTree::Box point{{0, 0, 0}, {0, 0, 0}};
  EXPECT_TRUE(may_be_nearer(point, {2 * tiny, 0, 0}, 5 * tiny));
  EXPECT_TRUE(may_be_farther(point, {9 * tiny, 0, 0}, 2 * tiny));
}

std::string gas(std::size_t side, const std::string& more_species, const std::string& pairs) {
  std::string text = R"({"tps":1,"dimension":3,"duration":1,"species":{"A":{"mass":1,"radius":0.4},)" +
                     more_species + R"("W":{"mass":"inf","radius":1000}},"pairs":[)" + pairs +
                     R"(],"particles":[)";
  for (std::size_t n = 0; n < side * side * side; ++n) {
    text += "{\"species\":\"A\",\"position\":[" + std::to_string(n % side) + "," +
            std::to_string(n / side % side) + "," + std::to_string(n / side / side) + "]},";
  }
  return text + R"({"species":"W","position":[0,0,0]}]})";
}

TEST(Starts, TwentyThousandParticlesAreCheckedInASecondOrTwo) {
  for (
      const char* pairs :
      {R"({"between":["A","A"],"blocking":{"c_rebound":1}})",
       R"({"between":["A","A"],"tethering":{"form":"permanent","distance":60,"c_retract":1,"c_revolve":1,"theta_revolve_deg":45}})",
       R"({"between":["A","W"],"tethering":{"form":"permanent","distance":60,"c_retract":1,"c_revolve":1,"theta_revolve_deg":45}})"}) {
    const double start = processor_seconds();
    EXPECT_EQ(read_scene_text(gas(27, "", pairs), "gas").particles.size(), 19684U);
    EXPECT_LT(processor_seconds() - start, 20) << pairs;
  }
}

}  // namespace
}  // namespace tps
