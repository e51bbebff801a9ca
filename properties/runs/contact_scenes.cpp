#include "properties/runs/contact_scenes.hpp"

#include <cmath>

#include "properties/runs/choices.hpp"

namespace tps::properties::runs {
namespace {

Scene contacts(int dimension) {
  Scene scene;
  scene.dimension = dimension != 0 ? dimension : pick({2, 3});
  scene.duration = 1;
  const int pairs = *rc::gen::inRange(1, 33);
  for (int n = 0; n < pairs; ++n) {
    const double angle = *rc::gen::inRange(0, 1000);
    const double speed = around_zero(3000) / 997.0;
    const Coordinates across{-speed * std::sin(angle), speed * std::cos(angle), 0};
    scene.species.push_back({"s" + std::to_string(n), 1, 0.5, {}});
    scene.pairs.push_back({n, n, BlockingLaw{1, 1}, {}});
    scene.particles.push_back({2 * n, n, {}, {}});
    scene.particles.push_back({2 * n + 1, n, {std::cos(angle), std::sin(angle), 0}, across});
  }
  return scene;
}

}  // namespace

rc::Gen<SmallScene> touching_pairs(int dimension) {
  return rc::gen::resize(rc::kNominalSize,
                         rc::gen::exec([dimension] { return SmallScene{contacts(dimension)}; }));
}

}  // namespace tps::properties::runs
