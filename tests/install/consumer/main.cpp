// What a user of the installed library writes: an equation, a scene, a run.
#include <cstdio>

#include "reference/equations/eq2_collision_time.hpp"
#include "reference/run/run.hpp"
#include "verify/scenes/registry.hpp"

int main() {
  using Vec = tps::Vector<double, 2>;
  const auto hit = tps::block_time<double, 2>(Vec(0, 0), Vec(5, 0), Vec(1, 0), Vec(0, 0), 1);
  const tps::RunSummary summary = tps::run_scene(tps::scene_builder("three-body").build({}), {});
  std::printf("t = %g, %llu collisions\n", *hit.t,
              static_cast<unsigned long long>(summary.by_kind.at("rebound")));
}
