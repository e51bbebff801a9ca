#include "verify/scenes/ring.hpp"

#include <algorithm>
#include <cmath>

namespace tps {

Scene build_ring(const RingParams& params) {
  const double chord = std::sqrt(2 - std::sqrt(3.0));  // 2 sin 15°
  Scene scene;
  scene.title = "A taut ring of twelve";
  scene.dimension = 2;
  scene.duration = params.duration;
  scene.species = {{.name = "bead", .mass = 1, .radius = chord / 4, .max_tethers = {}}};
  scene.pairs = {{.species_a = 0,
                  .species_b = 0,
                  .blocking = BlockingLaw{.distance = chord / 2, .c_rebound = params.restitution},
                  .tethering = TetheringLaw{.distance = chord,
                                            .c_retract = params.restitution,
                                            .c_revolve = params.restitution,
                                            .theta_revolve_deg = 45,
                                            .form = {.when = FormRule::When::never},
                                            .breaks = {.when = BreakRule::When::never}}}};
  if (params.grouped > 0) scene.grouping = Grouping{params.grouped};

  const double cos30 = std::sqrt(3.0) / 2;
  const std::array<double, 12> cosine{1, cos30, 0.5, 0, -0.5, -cos30, -1, -cos30, -0.5, 0, 0.5, cos30};
  for (int i = 0; i < 12; ++i) {
    const double x = cosine[static_cast<std::size_t>(i)];
    const double y = cosine[static_cast<std::size_t>((i + 9) % 12)];  // sin φ = cos(φ - 90°)
    scene.particles.push_back(
        {.id = i, .species = 0, .position = {x, y, 0}, .velocity = {params.speed * x, params.speed * y, 0}});
    scene.tethers.push_back({std::min(i, (i + 1) % 12), std::max(i, (i + 1) % 12)});
  }
  return scene;
}

SceneBuilder ring_builder() {
  using P = RingParams;
  return make_builder<P>(
      "ring", "twelve particles in a ring of taut tethers, all moving outwards",
      {{"speed", &P::speed, from_to(0, 1e100), "outwards, at the start"},
       {"restitution", &P::restitution, from_to(0, 1), "c_rebound, c_retract and c_revolve"},
       {"grouped", &P::grouped, from_to(0, 1e6), "dt_restitute of grouping; 0: no grouping"},
       {"duration", &P::duration, above(0), "time simulated"}},
      &build_ring);
}

}  // namespace tps
