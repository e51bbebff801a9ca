// Contacts that neither approach nor recede but for rounding.
#include <cmath>

#include "properties/runs/choices.hpp"
#include "properties/runs/collision.hpp"
#include "properties/runs/contact_scenes.hpp"
#include "properties/runs/laws.hpp"
#include "reference/equations/directed_rounding.hpp"

namespace tps::properties::runs {
namespace {

/// Pairs of a ball and a wall, each of species of its own, that meet head-on along directions of small
/// integers and keep little or nothing of their speed: rounding decides the sign of what is left.
Scene head_on(int dimension) {
  Scene scene;
  scene.dimension = dimension != 0 ? dimension : pick({2, 3});
  scene.duration = 10;
  const int pairs = *rc::gen::inRange(1, 33);
  for (int n = 0; n < pairs; ++n) {
    const double c = pick({0., 0., 0x1p-60, .5});
    const auto coordinate = [] { return 1. * *rc::gen::inRange(-9, 10); };
    const Coordinates away{pick({1., 2., 3., 7.}), coordinate(), scene.dimension == 3 ? coordinate() : 0};
    Coordinates start{}, approach{};
    for (std::size_t k = 0; k < 3; ++k) {
      start[k] = 3 * away[k];
      approach[k] = -away[k] / 3;
    }
    scene.species.push_back({"s" + std::to_string(n), 1, 0.5, {}});
    scene.species.push_back({"w" + std::to_string(n), HUGE_VAL, 0.5, {}});
    scene.pairs.push_back({2 * n, 2 * n + 1, BlockingLaw{1, c}, {}});
    scene.particles.push_back({2 * n, 2 * n, start, approach});
    scene.particles.push_back({2 * n + 1, 2 * n + 1, {}, {}});
  }
  return scene;
}

/// By the exact sign of r·v' of the stored numbers; a load promises nothing.
RunVerdict departs(const Scene& scene, Simulator& simulator) {
  return RunVerdict::of(first_fault(
      scene, simulator, [](const ImpliedState&, const TracedEvent& event) -> std::optional<std::string> {
        if (!event.is_collision() || event.is_load() || event.dp.value().isZero(0)) return std::nullopt;
        const TracedState &i = event.post.at(*event.i), &j = event.post.at(*event.j);
        const int sign = normal_sign<Real, 3>(i.position, j.position, i.velocity, j.velocity);
        if (event.kind == "rebound" && sign < 0) return "the pair approaches after its rebound";
        if (event.kind != "rebound" && sign >= 0 && i.velocity != j.velocity)
          return "the pair does not come together after its pull";
        return std::nullopt;
      }));
}

/// Δp is parallel to the axis to a few u, so that its sign is that of v_n, however small.
RunVerdict repels(const Scene& scene, Simulator& simulator) {
  return RunVerdict::of(
      first_fault(scene, simulator,
                  [](const ImpliedState& before, const TracedEvent& event) -> std::optional<std::string> {
                    if (event.kind != "rebound") return std::nullopt;
                    const Collided c = collided(before, event);
                    if (event.dp.value().dot(c.axis) > 0) return "the impulse attracts";
                    return std::nullopt;
                  }));
}

}  // namespace

std::vector<RunLaw> contact_laws() {
  return {
      {22, "Repulsion",
       "No rebound attracts: where rounding leaves a pair receding at its inner limit, the event stands "
       "with Δp = 0.",
       "docs/decisions.md", touching_pairs, repels},
      {24, "Departure",
       "After a rebound the stored velocities of a pair do not approach, in exact arithmetic; after a pull "
       "they come together, or the pair is at rest (D22).",
       "docs/engine.md",
       [](int dimension) {
         return rc::gen::resize(rc::kNominalSize,
                                rc::gen::exec([dimension] { return SmallScene{head_on(dimension)}; }));
       },
       departs}};
}

}  // namespace tps::properties::runs
