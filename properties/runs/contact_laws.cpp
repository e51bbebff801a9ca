// Contacts that neither approach nor recede but for rounding.
#include <cmath>

#include "properties/runs/choices.hpp"
#include "properties/runs/collision.hpp"
#include "properties/runs/laws.hpp"

namespace tps::properties::runs {
namespace {

/// Pairs that touch and move across, each of a species of its own, so that none knows of the others. Whether
/// r·v and v·û come out negative, zero or positive is rounding: in one of some hundred pairs they disagree.
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

/// Δp is parallel to the axis to a few u, so that its sign is that of v_n, however small.
RunVerdict repels(const Scene& scene, Simulator& simulator) {
  return RunVerdict::of(first_fault(
      scene, simulator, [](const Replay& before, const TracedEvent& event) -> std::optional<std::string> {
        if (event.kind != "rebound") return std::nullopt;
        const Collided c = collided(before, event);
        if (event.dp.value().dot(c.axis) > 0) return "the impulse attracts";
        return std::nullopt;
      }));
}

}  // namespace

std::vector<RunLaw> contact_laws() {
  return {{22, "Repulsion",
           "No rebound attracts: where rounding leaves a pair receding at its inner limit, the event stands "
           "with Δp = 0.",
           "docs/decisions.md",
           [](int dimension) {
             return rc::gen::resize(rc::kNominalSize,
                                    rc::gen::exec([dimension] { return SmallScene{contacts(dimension)}; }));
           },
           repels}};
}

}  // namespace tps::properties::runs
