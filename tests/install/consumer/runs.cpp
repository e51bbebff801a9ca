// What a user of tps::reference writes: an equation, a scene, a run.
#include <cstdio>

#include "reference/equations/eq2_collision_time.hpp"
#include "reference/run/run.hpp"
#include "reference/scene/read_scene.hpp"

int main(int, char** argv) {
  using Vec = tps::Vector<double, 2>;
  const auto hit = tps::block_time<double, 2>(Vec(0, 0), Vec(5, 0), Vec(1, 0), Vec(0, 0), 1);
  tps::RunOptions options;
  options.trace = argv[2];
  const tps::RunSummary summary = tps::run_scene(tps::read_scene_file(argv[1]), options);
  std::printf("t = %g, %llu collisions\n", *hit.t,
              static_cast<unsigned long long>(summary.by_kind.at("rebound")));
}
